// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/plane_sides.hpp"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cmath>
#include <numbers>
#include <optional>

#include "generator/commands/ghost_side.hpp"
#include "generator/exact/rational.hpp"
#include "generator/families/projected.hpp"
#include "generator/families/vector_family.hpp"
#include "generator/plane/side_reflection.hpp"
#include "generator/support/on_all_cores.hpp"

namespace nmbcgen {
namespace {

constexpr std::array angles{0.0, 20.0, 35.0, 40.0, 60.0, 80.0};  // from the normal [degrees]
constexpr double reflected_xi = 0.1;

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

std::vector<GhostSide> ghost_sides(const SideTask& model, const PlaneLattice& lattice) {
    std::vector<GhostSide> sides{
        {.name = "NMBC1 as printed, (81)", .condition = published_condition(lattice)},
        {.name = "NMBC1 by component", .condition = polarisation_wise_condition(lattice)}};
    const unsigned stride = horizon_of(model.choice);
    const Specification second_order{
        .family = {}, .horizon = stride, .order = 2, .stride = stride, .stabilisation = {}};
    if (auto second = component_condition(model, lattice, second_order)) {
        sides.push_back({.name = component_name(2, stride), .condition = std::move(*second)});
    }
    sides.push_back(
        {.name = "Higdon, P and S", .condition = higdon_condition(lattice, drift_shift)});
    return sides;
}

template <class Reflected>
std::string reflections_of(const PlaneLattice& lattice, Reflected reflected) {
    std::string text;
    for (const double angle : angles) {
        text +=
            fmt::format("  {:.3f}/{:.3f}", reflected(told_wave(lattice, true, reflected_xi, angle)),
                        reflected(told_wave(lattice, false, reflected_xi, angle)));
    }
    return text;
}

constexpr const char* row_format = "{:<26} {:<11} {:>10} {:>9} {:>5} {}\n";

std::string row_of(const GhostSide& side, const PlaneLattice& lattice, std::size_t reach) {
    const bool grows = side.growth > 0;
    return fmt::format(row_format, side.name, grade_of(side), amplification_of(side),
                       grows ? fmt::format("{:.2g}", side.growth) : "none",
                       side.damping ? to_string(*side.damping)
                       : grows      ? "-"
                                    : "0",
                       reflections_of(lattice, [&](const ArrivingWave& wave) {
                           return reflected_in_plane(wave, side.condition, reach);
                       }));
}

/// The sides there are, the passive one apart.
std::vector<GhostSide> ghost_sides_with(const std::vector<AbsorbedWave>& absorbed,
                                        const SideTask& model, const PlaneLattice& lattice) {
    std::vector<GhostSide> sides = ghost_sides(model, lattice);
    if (!absorbed.empty()) {
        sides.push_back(side_absorbing(absorbed, lattice));
    }
    return sides;
}

template <class Reflected>
std::string reflection_rows(std::string boundary, const PlaneLattice& lattice,
                            Reflected reflected) {
    std::erase(boundary, ',');
    std::string rows;
    for (const double xi : {0.1, 0.5, 1.0}) {
        for (const bool is_P : {true, false}) {
            for (int degrees = 0; degrees < 90; ++degrees) {
                rows += fmt::format("{},{},{},{},{:.4g}\n", boundary, is_P ? 'P' : 'S', xi, degrees,
                                    reflected(told_wave(lattice, is_P, xi, degrees)));
            }
        }
    }
    return rows;
}

std::string heading() {
    std::string text =
        fmt::format(row_format, "boundary", "grade", "amplifies", "growth", "tau", "");
    text.pop_back();
    for (const double angle : angles) {
        text += fmt::format("  {:>7} deg", angle);
    }
    return text + "\n";
}

}  // namespace

std::string side_recommendation(const SideTask& model, const std::vector<AbsorbedWave>& absorbed,
                                const Progress& progress) {
    const VectorModel described = find_vector_family(model.family).describe(model.choice);
    const PlaneLattice lattice = plane_lattice(described, model.g, 0);
    std::vector<GhostSide> sides = ghost_sides_with(absorbed, model, lattice);
    std::optional<DesignedSide> passive;
    std::atomic<std::size_t> done = 0;
    const std::size_t all = sides.size() + 1;
    progress(0, all);
    on_all_cores(all, [&](std::size_t i) {
        if (i == 0) {
            passive = designed(model);
        } else {
            examine(sides[i - 1], model, lattice);
        }
        progress(++done, all);
    });
    std::string table =
        heading() + fmt::format(row_format, "passive", "passive", "no", "none", "0",
                                reflections_of(lattice, [&](const ArrivingWave& wave) {
                                    return reflected_by_edge(passive->task, passive->edge, wave);
                                }));
    const std::size_t reach = lateral_chain(lattice, 0).reach();
    for (const GhostSide& side : sides) {
        table += row_of(side, lattice, reach);
    }
    return fmt::format(
        "passive, on the {} outermost layers of {}, g = {}\n"
        "  proved     this straight side adds no energy: with others that add none a body keeps "
        "what "
        "it has or less\n"
        "  designed   for waves up to {:g} degrees from the normal; what is left head-on does not "
        "vanish for long waves\n"
        "  steps      times {:.2f} of those without it, beside an endless side\n\n"
        "{}\n"
        "grade: passive is proved. Found on samples, {} x {} wave vectors and strips of {} layers "
        "with {} wave numbers\n"
        "  along them, and without corners: contractive (opposite any passive side), paired "
        "(opposite its like),\n"
        "  amplifies, grows (in the strip)\n"
        "amplifies: amplitudes at one reflection between like sides, the largest; <=: a bound\n"
        "growth: rate in the strip [sqrt(E/density)/dX]; tau: least of 1/100 .. 2 that ends it in "
        "this strip, of\n"
        "  forces tau times those of the stabilisation at g = 1 on velocities [dX "
        "sqrt(density/E)]; -: none\n"
        "degrees: from the normal; reflected energy of P/S, xi = {:g}/dX\n",
        passive->design.strain.size(), described.description, to_string(model.g),
        widest_designed_angle,
        std::sqrt(passive->task.highest_eigenvalue / passive->highest_eigenvalue), table,
        side_samples.waves, side_samples.waves + 1, side_samples.layers,
        side_samples.wave_numbers + 1, reflected_xi);
}

std::string side_reflection_csv(const SideTask& model, const std::vector<AbsorbedWave>& absorbed,
                                const Progress& progress) {
    const VectorModel described = find_vector_family(model.family).describe(model.choice);
    const PlaneLattice lattice = plane_lattice(described, model.g, 0);
    const std::vector<GhostSide> sides = ghost_sides_with(absorbed, model, lattice);
    const std::size_t reach = lateral_chain(lattice, 0).reach();
    std::vector<std::string> rows(sides.size() + 1);
    std::atomic<std::size_t> done = 0;
    progress(0, rows.size());
    on_all_cores(rows.size(), [&](std::size_t i) {
        if (i == 0) {
            const DesignedSide passive = designed(model);
            rows[i] = reflection_rows("passive", lattice, [&](const ArrivingWave& wave) {
                return reflected_by_edge(passive.task, passive.edge, wave);
            });
        } else {
            const GhostSide& side = sides[i - 1];
            rows[i] = reflection_rows(side.name, lattice, [&](const ArrivingWave& wave) {
                return reflected_in_plane(wave, side.condition, reach);
            });
        }
        progress(++done, rows.size());
    });
    std::string csv = "boundary,wave,xi,degrees,reflected\n";
    for (const std::string& of_side : rows) {
        csv += of_side;
    }
    return csv;
}

}  // namespace nmbcgen
