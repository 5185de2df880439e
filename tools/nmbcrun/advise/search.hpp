// SPDX-License-Identifier: MIT
/// The search among the boundaries and time steps of one lattice.
#pragma once

#include <map>
#include <nmbc/lattice.hpp>
#include <nmbc/table.hpp>
#include <optional>

#include "tools/nmbcrun/advise/candidates.hpp"
#include "tools/nmbcrun/advise/interior_error.hpp"
#include "tools/nmbcrun/advise/outgoing.hpp"
#include "tools/nmbcrun/advise/predicted_error.hpp"

namespace nmbcrun {

class Search {
  public:
    /// The scene's lattice is settled. Throws as Simulation does, and SceneError where nothing
    /// moves.
    Search(const Scene& scene, double tolerance, Reference reference);

    Search(const Search&) = delete;
    Search& operator=(const Search&) = delete;

    /// Every boundary of the lattice, in the longest steps in which it meets the tolerance, or why
    /// it is left out.
    Candidates all();

    /// The least that was found for the interior alone in any steps: above the tolerance, no end
    /// could help.
    double least_interior_error() const { return least_interior_error_; }

  private:
    double step_of(double cfl) const { return 2 * cfl / omega_max_; }  // [dX/c]
    std::optional<double> given_cfl() const;
    Outgoing probing_waves() const;
    double interior_error_at(double cfl);
    Candidate candidate(const std::string& name, const Boundary& boundary, double cfl) const;
    template <class ErrorAt>
    void add(const std::string& name, const Boundary& boundary, double highest,
             const std::string& limit, ErrorAt error_at);
    template <class ErrorAt>
    bool try_steps(Candidate candidate, ErrorAt error_at, double& best);
    void add_ends_of_the_lattice();
    void add_table(const nmbc::MatchingTable& table);
    void leave_out(const std::string& name, const std::string& reason);

    const Scene& scene_;
    double tolerance_;
    Reference reference_;
    nmbc::Lattice lattice_;
    double omega_max_;
    double unit_;  // dX/c
    EndlessScene endless_;
    Outgoing outgoing_;
    ReflectionError reflection_error_;
    InteriorError interior_error_;
    std::map<double, double> interior_errors_;  // by cfl
    double least_interior_error_;
    Candidates result_;
};

}  // namespace nmbcrun
