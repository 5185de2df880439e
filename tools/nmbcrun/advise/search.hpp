// SPDX-License-Identifier: MIT
/// The search among the boundaries and time steps of one lattice.
#pragma once

#include <limits>
#include <map>
#include <nmbc/lattice.hpp>
#include <nmbc/table.hpp>
#include <optional>

#include "tools/nmbcrun/advise/candidates.hpp"
#include "tools/nmbcrun/advise/interior_error.hpp"
#include "tools/nmbcrun/advise/outgoing.hpp"
#include "tools/nmbcrun/advise/predicted_error.hpp"

namespace nmbcrun {

/// Of a search among several lattices.
struct Scope {
    double favoured_cfl = 0;  ///< to be tried, too, where it is certified; 0: none
    double most_steps = std::numeric_limits<double>::infinity();  ///< in more, nothing is tried
};

/// A predicted error times this has to be within the tolerance: for what predictions leave out,
/// what happens between the times they look at.
inline constexpr double error_margin = 1.1;

class Search {
  public:
    /// The scene's lattice is settled. Throws as Simulation does, and SceneError where nothing
    /// moves.
    Search(const Scene& scene, double tolerance, Reference reference, const Pause& pause,
           const Scope& scope = {});

    Search(const Search&) = delete;
    Search& operator=(const Search&) = delete;

    /// Every boundary of the lattice, in the longest steps in which it meets the tolerance, or why
    /// it is left out.
    Candidates all();

    /// Whether the interior alone met the tolerance in any steps that were tried.
    bool interior_meets() const { return interior_meets_; }

    /// Of the interior alone, in the steps in which it is likely to be least.
    double least_interior_error();

  private:
    struct Verdict {
        bool meets;
        double error;  // infinite where the ends were not looked at
        std::string reason;
    };

    double step_of(double cfl) const { return 2 * cfl / omega_max_; }  // [dX/c]
    std::optional<double> given_cfl() const;
    Outgoing probing_waves();
    double next_shorter(double cfl) const;
    double interior_error_at(double cfl);
    double interior_error_of(double cfl, double enough);
    Candidate candidate(const std::string& name, const Boundary& boundary, double cfl) const;
    template <class ErrorAt>
    void add(const std::string& name, const Boundary& boundary, const nmbc::StableStep& steps,
             const std::string& limit, ErrorAt error_at);
    template <class BoundaryError>
    Verdict judge(Candidate& candidate, BoundaryError boundary_error);
    /// What true ends allow, or the interior.
    double cfl_of_true_ends() const;
    void add_ends_of_the_lattice();
    void add_passive();
    void add_table(const nmbc::MatchingTable& table);
    void leave_out(const std::string& name, const std::string& reason);

    const Scene& scene_;
    double tolerance_;
    Reference reference_;
    Scope scope_;
    nmbc::Lattice lattice_;
    double omega_max_;
    double unit_;  // dX/c
    EndlessScene endless_;
    Outgoing outgoing_;
    ReflectionError reflection_error_;
    InteriorError interior_error_;
    std::map<double, double> interior_errors_;  // by cfl
    bool interior_meets_ = false;
    Candidates result_;
};

}  // namespace nmbcrun
