// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/candidates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nmbc/certificate.hpp>
#include <nmbc/coefficients.hpp>
#include <nmbc/lattice.hpp>
#include <optional>

#include "tools/nmbcrun/advise/outgoing.hpp"
#include "tools/nmbcrun/advise/predicted_error.hpp"
#include "tools/nmbcrun/simulation/tables.hpp"
#include "tools/nmbcrun/simulation/time_step.hpp"

namespace nmbcrun {
namespace {

/// The cfl that waves are looked at with, where the scene gives none.
constexpr double probing_cfl = 0.2;
constexpr double largest_cfl = 0.99;  // of ends that do not limit it
constexpr double smallest_cfl = 0.01;
/// What predictions leave out: second round trips, and what the sources' own steps are off by.
constexpr double margin = 1.1;

/// The next of cfl 0.99, 0.99 * 0.95, .. below: near enough to the longest for any use.
double next_shorter(double cfl) {
    constexpr double shorter = 0.95;
    double next = largest_cfl;
    while (next > cfl * (1 - 1e-9)) {
        next *= shorter;
    }
    return next;
}

class Search {
  public:
    Search(const Scene& scene, double tolerance)
        : scene_(scene),
          tolerance_(tolerance),
          lattice_(lattice_of(scene)),
          omega_max_(nmbc::maximum_frequency(lattice_)),
          unit_(scene.spacing / std::sqrt(scene.youngs_modulus / scene.density)),
          outgoing_(outgoing_waves(scene, given_cfl().value_or(probing_cfl))),
          reflection_error_(scene, outgoing_) {}

    Candidates all() {
        add_ends_of_the_lattice();
        for (const nmbc::MatchingTable* table : tables_of(scene_)) {
            add_table(*table);
        }
        result_.left_out.push_back(
            {"sponge, pml",
             "a layer takes nodes and steps of its own: where a ghost rule will not "
             "do, \"extended\" and \"exact\" have no error at all"});
        result_.left_out.push_back({"higdon, mbc", "not certified to be stable"});
        return std::move(result_);
    }

  private:
    double step_of(double cfl) const { return 2 * cfl / omega_max_; }  // [dX/c]

    std::optional<double> given_cfl() const {
        return scene_.step ? *scene_.step / unit_ * omega_max_ / 2 : scene_.cfl;
    }

    double time_error_at(double cfl) {
        if (given_cfl()) {
            return 0;
        }
        const auto [known, is_new] = time_errors_.try_emplace(cfl, 0.0);
        if (is_new) {
            known->second = time_error(outgoing_, scene_.nodes, step_of(cfl));
        }
        return known->second;
    }

    Candidate candidate(const std::string& name, const Boundary& boundary, double cfl,
                        double boundary_error) {
        return {.name = name,
                .boundary = boundary,
                .cfl = cfl,
                .time_step = step_of(cfl) * unit_,
                .steps = steps_until(scene_.end, step_of(cfl) * unit_),
                .boundary_error = boundary_error,
                .time_error = time_error_at(cfl)};
    }

    /// In the longest steps up to a cfl in which it meets the tolerance. error_at(cfl): of the
    /// boundary.
    template <class ErrorAt>
    void add(const std::string& name, const Boundary& boundary, double highest, ErrorAt error_at) {
        if (const auto given = given_cfl()) {
            if (*given > highest * (1 + 1e-9)) {
                leave_out(name,
                          fmt::format("certified up to cfl = {:.3g}, and the scene has {:.3g}",
                                      highest, *given));
                return;
            }
            highest = *given;
        }
        double best = std::numeric_limits<double>::infinity();
        for (double cfl = highest; cfl >= smallest_cfl; cfl = next_shorter(cfl)) {
            const Candidate one = candidate(name, boundary, cfl, error_at(cfl));
            if (one.error() * margin <= tolerance_) {
                result_.meet.push_back(one);
                return;
            }
            best = std::min(best, one.error());
            if (given_cfl() || one.boundary_error > 100 * tolerance_) {
                break;  // shorter steps change little of what the condition reflects
            }
        }
        leave_out(name, fmt::format("predicted error {:.2g}", best));
    }

    void add_ends_of_the_lattice() {
        const auto none = [](double) { return 0.0; };
        const double highest = largest_cfl * nmbc::interior_cfl(lattice_);
        add("no boundary (fixed)", {.kind = BoundaryKind::fixed}, highest,
            [&](double cfl) { return reflection_error_.of_fixed_ends(step_of(cfl)); });
        add("extended", {.kind = BoundaryKind::extended}, highest, none);
        if (!scene_.incoming && !scene_.preload) {
            add("exact", {.kind = BoundaryKind::exact}, highest, none);
        }
    }

    void add_table(const nmbc::MatchingTable& table) {
        const Boundary boundary{.order = table.order,
                                .stride = table.stride,
                                .matched_step = std::string(table.time_step)};
        const std::string name = fmt::format(
            "NMBC{}, stride {}{}", table.order, table.stride,
            table.time_step == "0" ? std::string()
                                   : fmt::format(", in steps of {} dX/c", table.time_step));
        const double highest = nmbc::certified_cfl(table, scene_.G);
        if (highest == 0) {
            leave_out(name, uncertified_file(scene_, table) == nullptr
                                ? "not certified at this G"
                                : "its table was written with --uncertified");
            return;
        }
        if (scene_.nodes < std::size_t(table.least_nodes)) {
            leave_out(name, fmt::format("certified from {} nodes on", table.least_nodes));
            return;
        }
        const double matched = nmbc::detail::nearest_to_fraction(table.time_step);
        const double own_cfl = matched * omega_max_ / 2;
        if (matched > 0 && (given_cfl() || own_cfl > highest)) {
            leave_out(name,
                      given_cfl() ? "its step is not the scene's" : "its step is not certified");
            return;
        }
        const auto error_at = [&](double cfl) {
            return reflection_error_.of(boundary, step_of(cfl));
        };
        if (matched == 0) {
            add(name, boundary, highest, error_at);
            return;
        }
        const Candidate one = candidate(name, boundary, own_cfl, error_at(own_cfl));
        if (one.error() * margin <= tolerance_) {
            result_.meet.push_back(one);
        } else {
            leave_out(name, fmt::format("predicted error {:.2g} in its step", one.error()));
        }
    }

    void leave_out(const std::string& name, const std::string& reason) {
        result_.left_out.push_back({name, reason});
    }

    const Scene& scene_;
    double tolerance_;
    nmbc::Lattice lattice_;
    double omega_max_;
    double unit_;
    Outgoing outgoing_;
    ReflectionError reflection_error_;
    std::map<double, double> time_errors_;  // by cfl
    Candidates result_;
};

}  // namespace

Candidates find_candidates(const Scene& scene, double tolerance) {
    return Search(scene, tolerance).all();
}

}  // namespace nmbcrun
