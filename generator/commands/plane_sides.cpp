// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/plane_sides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generator/commands/ghost_side.hpp"
#include "generator/exact/rational.hpp"
#include "generator/families/projected.hpp"
#include "generator/families/vector_family.hpp"
#include "generator/passive/plane_side.hpp"
#include "generator/plane/side_reflection.hpp"
#include "generator/support/on_all_cores.hpp"

namespace nmbcgen {
namespace {

/// Waves of the table's reflected energies.
constexpr double long_xi = 0.1;                                  // [1/dX]
constexpr std::array angles{0.0, 20.0, 35.0, 40.0, 60.0, 80.0};  // from the normal [degrees]

constexpr double drift_shift = 0.002;  // [c/dX] 1e-3 of the factors' other entries

/// The product of a factor for each wave, on both components.
GhostSide side_absorbing(const std::vector<AbsorbedWave>& waves, const PlaneLattice& lattice) {
    std::string name;
    ShiftPolynomial factors;
    for (const auto& [polarisation, degrees] : waves) {
        const bool is_P = polarisation == Polarisation::P;
        const double apparent =
            (is_P ? lattice.speed_P : lattice.speed_S) / std::cos(degrees * std::numbers::pi / 180);
        // One factor does not drift.
        const ShiftPolynomial factor = absorbs(apparent, waves.size() == 1 ? 0 : drift_shift);
        factors = factors.empty() ? factor : product(factors, factor);
        name += fmt::format("{}{} {:g}", name.empty() ? "matched at " : ", ", is_P ? 'P' : 'S',
                            degrees);
    }
    return {.name = name, .condition = {{factors, factors}}};
}

/// All sides of a lattice but the passive one.
struct GhostSides {
    std::vector<GhostSide> found;
    std::string missing;  ///< the published one that there is none of here; empty: all are found
};

/// What is published, then what absorbs these waves, where there are any.
GhostSides ghost_sides(const SideTask& model, const PlaneLattice& lattice,
                       const std::vector<AbsorbedWave>& absorbed) {
    std::vector<GhostSide> sides{
        {.name = "NMBC1 as printed, (81)", .condition = published_condition(lattice)},
        {.name = "NMBC1 by component", .condition = polarisation_wise_condition(lattice)}};
    const unsigned stride = horizon_of(model.choice);
    const Specification second_order{
        .family = {}, .horizon = stride, .order = 2, .stride = stride, .stabilisation = {}};
    auto second = component_condition(model, lattice, second_order);
    const std::string missing = second ? "" : component_name(2, stride);
    if (second) {
        sides.push_back({.name = component_name(2, stride), .condition = std::move(*second)});
    }
    sides.push_back(
        {.name = "Higdon, P and S", .condition = higdon_condition(lattice, drift_shift)});
    if (!absorbed.empty()) {
        sides.push_back(side_absorbing(absorbed, lattice));
    }
    return {std::move(sides), missing};
}

template <class Reflected>
std::string reflections_of(const PlaneLattice& lattice, Reflected reflected) {
    const auto of_wave = [&](bool is_P, double angle) -> std::string {
        const auto wave = told_wave(lattice, is_P, long_xi, angle);
        return wave ? fmt::format("{:.3f}", reflected(*wave)) : "?";
    };
    std::string text;
    for (const double angle : angles) {
        text += fmt::format("  {:>5}/{:>5}", of_wave(true, angle), of_wave(false, angle));
    }
    return text;
}

constexpr const char* row_format = "{:<26} {:<11} {:>5} {:<15} {:>10} {:>8} {:>8} {:>8} {:>5} {}\n";

/// A lattice and the sides there are for it.
struct SidesOfLattice {
    SideTask model;
    VectorModel described;
    PlaneLattice lattice;
    std::size_t reach;
    GhostSides ghosts;

    SidesOfLattice(const SideTask& task, const std::vector<AbsorbedWave>& absorbed)
        : model(task),
          described(find_vector_family(task.family).describe(task.choice)),
          lattice(plane_lattice(described, task.g, 0)),
          reach(lateral_chain(lattice, 0).reach()),
          ghosts(ghost_sides(task, lattice, absorbed)) {}

    bool has_passive() const { return find_vector_family(model.family).at_edge != nullptr; }

    double reflected_by(const GhostSide& side, const ArrivingWave& wave) const {
        return reflected_in_plane(wave, side.condition, reach);
    }
};

/// Works on all cores: passive_side(design), where the family has them, and ghost_side(i).
template <class PassiveSide, class Ghost>
void for_each_side(const SidesOfLattice& sides, const Progress& progress, PassiveSide passive_side,
                   Ghost ghost_side) {
    std::atomic<std::size_t> done = 0;
    const std::size_t designs = sides.has_passive() ? 1 : 0;
    const std::size_t all = sides.ghosts.found.size() + designs;
    progress(0, all);
    on_all_cores(all, [&](std::size_t i) {
        if (i < designs) {
            passive_side(designed(sides.model));
        } else {
            ghost_side(i - designs);
        }
        progress(++done, all);
    });
}

std::string rate_text(double growth) {
    return growth > 0 ? fmt::format("{:.2g}", growth) : "none";
}

/// Beside an endless side.
double share_of_steps(const DesignedSide& passive) {
    return std::sqrt(passive.task.highest_eigenvalue / passive.highest_eigenvalue);
}

std::string row_of(const DesignedSide& passive, const SidesOfLattice& sides) {
    return fmt::format(row_format, "passive", "passive",
                       fmt::format("{:.2f}", share_of_steps(passive)), "any", "no", "none", "none",
                       "none", "0", reflections_of(sides.lattice, [&](const ArrivingWave& wave) {
                           return reflected_by_edge(passive.task, passive.edge, wave);
                       }));
}

std::string row_of(const GhostSide& side, const SidesOfLattice& sides) {
    return fmt::format(row_format, side.name, grade_of(side), steps_of(side), opposite_of(side),
                       amplification_of(side), rate_text(side.growth_of_modes),
                       rate_text(side.growth_in_strips), rate_text(side.growth_with_corners),
                       side.damping   ? to_string(*side.damping)
                       : side.grows() ? "-"
                                      : "0",
                       reflections_of(sides.lattice, [&](const ArrivingWave& wave) {
                           return sides.reflected_by(side, wave);
                       }));
}

template <class Reflected>
std::string reflection_rows(std::string boundary, const PlaneLattice& lattice,
                            Reflected reflected) {
    std::erase(boundary, ',');
    std::string rows;
    for (const double xi : {0.1, 0.5, 1.0}) {
        for (const bool is_P : {true, false}) {
            for (int degrees = 0; degrees < 90; ++degrees) {
                const auto wave = told_wave(lattice, is_P, xi, degrees);
                rows += fmt::format("{},{},{},{},{}\n", boundary, is_P ? 'P' : 'S', xi, degrees,
                                    wave ? fmt::format("{:.4g}", reflected(*wave)) : "");
            }
        }
    }
    return rows;
}

std::string heading() {
    std::string text = fmt::format(row_format, "boundary", "grade", "steps", "opposite",
                                   "amplifies", "side", "strip", "box", "tau", "");
    text.pop_back();
    for (const double angle : angles) {
        text += fmt::format("  {:>7} deg", angle);
    }
    return text + "\n";
}

/// What is recommended: the passive side.
std::string choice_of(const DesignedSide& passive, const SidesOfLattice& sides) {
    return fmt::format(
        "passive, on the {} outermost layers of {}, g = {}\n"
        "  stable     by construction: this straight side adds no energy. A body between sides "
        "that add none gains none\n"
        "  designed   for waves up to {:g} degrees from the normal; what is left head-on does not "
        "vanish for long waves\n"
        "  steps      times {:.2f} of those without it, beside an endless side\n",
        passive.design.strain.size(), sides.described.description, to_string(sides.model.g),
        widest_designed_angle(passive), share_of_steps(passive));
}

/// Where none is designed: the first one that is stable on the samples, contractive ones before
/// paired ones.
std::string choice_of(const SidesOfLattice& sides) {
    const GhostSide* best = nullptr;
    for (const char* grade : {"contractive", "paired"}) {
        const auto found = std::ranges::find_if(sides.ghosts.found, [&](const GhostSide& side) {
            return side.is_stable() && grade_of(side) == grade;
        });
        if (best == nullptr && found != sides.ghosts.found.end()) {
            best = &*found;
        }
    }
    const std::string at =
        fmt::format("{}, for which no passive sides are designed", sides.described.description);
    return best == nullptr ? fmt::format(
                                 "none of these sides is stable beside {}\n"
                                 "  instead    a lattice that goes on, or a layer with friction "
                                 "(a sponge): they add no energy. Passive\n"
                                 "             sides are for nopd2d and bond2d. --absorb looks at "
                                 "products for other waves\n",
                                 at)
                           : fmt::format(
                                 "{}, beside {}\n"
                                 "  stable     on samples alone: {} in steps up to {:.1f} of the "
                                 "lattice's longest\n",
                                 best->name, at, grade_of(*best), best->steps);
}

std::string legend() {
    return fmt::format(
        "grade: passive is by construction. On samples,\n"
        "  {}:\n"
        "  contractive (opposite any passive side), paired (opposite its like), amplifies, grows. "
        "Other strips may grow\n"
        "steps: the grade holds in continuous time and in leapfrog steps up to this part of the "
        "lattice's longest.\n"
        "  For passive sides that is the limit. For others it is the last tenth that was tried: "
        "the limit is up to a tenth higher\n"
        "opposite: in these steps and in continuous time; no fixed, no free: strips between the "
        "row's side and such a one grow\n"
        "amplifies: amplitudes at one reflection between like sides, the largest; <=: a bound\n"
        "side, strip, box: rates of growth in continuous time [sqrt(E/density)/dX]. side: of a "
        "mode of one, at the wave\n"
        "  numbers of the strips where modes can be told; strip: between two; box: between four, "
        "with corners\n"
        "tau: least of 1/100 .. 2 that ends all growth, of forces tau times those of the "
        "stabilisation at g = 1 on\n"
        "  velocities [dX sqrt(density/E)]; -: none\n"
        "degrees: from the normal; reflected energy of P/S, xi = {:g}/dX; ?: waves at the side "
        "cannot "
        "be told from each other\n",
        samples_text(), long_xi);
}

}  // namespace

std::string side_recommendation(const SideTask& model, const std::vector<AbsorbedWave>& absorbed,
                                const Progress& progress) {
    SidesOfLattice sides(model, absorbed);
    std::optional<DesignedSide> passive;
    for_each_side(
        sides, progress, [&](DesignedSide&& side) { passive = std::move(side); },
        [&](std::size_t i) { examine(sides.ghosts.found[i], model, sides.lattice); });
    std::string table = heading();
    if (passive) {
        table += row_of(*passive, sides);
    }
    for (const GhostSide& side : sides.ghosts.found) {
        table += row_of(side, sides);
    }
    if (!sides.ghosts.missing.empty()) {
        table += fmt::format("{}: none, at g = {} its equations have no solution\n",
                             sides.ghosts.missing, to_string(sides.model.g));
    }
    return fmt::format("{}\n{}\n{}", passive ? choice_of(*passive, sides) : choice_of(sides), table,
                       legend());
}

std::string side_reflection_csv(const SideTask& model, const std::vector<AbsorbedWave>& absorbed,
                                const Progress& progress) {
    const SidesOfLattice sides(model, absorbed);
    std::string of_passive;
    std::vector<std::string> rows(sides.ghosts.found.size());
    for_each_side(
        sides, progress,
        [&](const DesignedSide& passive) {
            of_passive = reflection_rows("passive", sides.lattice, [&](const ArrivingWave& wave) {
                return reflected_by_edge(passive.task, passive.edge, wave);
            });
        },
        [&](std::size_t i) {
            const GhostSide& side = sides.ghosts.found[i];
            rows[i] = reflection_rows(side.name, sides.lattice, [&](const ArrivingWave& wave) {
                return sides.reflected_by(side, wave);
            });
        });
    std::string csv = "boundary,wave,xi,degrees,reflected\n" + of_passive;
    for (const std::string& of_side : rows) {
        csv += of_side;
    }
    return csv;
}

}  // namespace nmbcgen
