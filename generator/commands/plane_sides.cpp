// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/plane_sides.hpp"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cmath>
#include <numbers>
#include <optional>

#include "generator/exact/rational.hpp"
#include "generator/names/projected_family.hpp"
#include "generator/pipeline.hpp"
#include "generator/plane/strip.hpp"
#include "generator/stability/half_space.hpp"
#include "generator/support/on_all_cores.hpp"

namespace nmbcgen {
namespace {

constexpr std::array angles{0.0, 20.0, 40.0, 60.0, 80.0};  // from the normal [degrees]
constexpr double reflected_xi = 0.1;
constexpr std::size_t layers = 20;
constexpr std::size_t strip_wave_numbers = 40;
constexpr std::size_t wave_samples = 24;  // in each direction

/// A boundary of ghost layers and what was found of it.
struct GhostSide {
    std::string name;
    SideCondition condition;
    LargestAmplification amplification{};
    StripGrowth growth{};
    std::optional<Rational> damping{};  ///< the smallest tau tried with which strips do not grow
};

/// Polarisation by polarisation, from the tables of the chains that waves along x see; nothing
/// where there is none.
std::optional<SideCondition> matching_condition(const PlaneModel& model,
                                                const PlaneLattice& lattice, unsigned order) {
    SideCondition condition;
    for (const Polarisation polarisation : {Polarisation::P, Polarisation::S}) {
        const ProjectedFamily projected{
            .family = model.family, .model = model.choice, .polarisation = polarisation};
        Specification what;
        what.family = name_of(projected);
        what.horizon = unsigned(std::sqrt(double(model.choice.radius_squared)));
        what.order = order;
        const bool is_P = polarisation == Polarisation::P;
        const double speed = is_P ? lattice.speed_P : lattice.speed_S;
        try {
            const HalfSpace half_space = make_half_space(derive(what), model.g);
            std::vector<double> minus_b = half_space.b;
            for (double& b : minus_b) {
                b *= -speed;
            }
            condition.residual[is_P ? 0 : 1] = {minus_b, half_space.c};
        } catch (const NoSuchBoundary&) {
            return std::nullopt;
        } catch (const std::domain_error&) {  // a pole
            return std::nullopt;
        }
    }
    return condition;
}

std::vector<GhostSide> ghost_sides(const PlaneModel& model, const PlaneLattice& lattice) {
    std::vector<GhostSide> sides{
        {.name = "NMBC1 as printed, (81)", .condition = published_condition(lattice)},
        {.name = "NMBC1 by component", .condition = polarisation_wise_condition(lattice)}};
    if (auto second = matching_condition(model, lattice, 2)) {
        sides.push_back({.name = "NMBC2 by component", .condition = std::move(*second)});
    }
    constexpr double shift = 0.002;  // [c/dX] against drift, 1e-3 of the factors' other entries
    sides.push_back({.name = "Higdon, P and S", .condition = higdon_condition(lattice, shift)});
    return sides;
}

/// Roundings of the eigenvalues of some hundred states.
constexpr double growth_limit = 1e-9;
/// Samples reach 1 at the edges of bands, where waves stand, up to the roundings of a double root.
constexpr double sampled_limit = 1 + 1e-6;

StripGrowth growth_of(const PlaneModel& model, const Rational& damping,
                      const SideCondition& condition) {
    const VectorModel described = find_vector_family(model.family).describe(model.choice);
    return largest_growth_in_strip(plane_lattice(described, model.g, damping), condition, layers,
                                   strip_wave_numbers);
}

void examine(GhostSide& side, const PlaneModel& model, const PlaneLattice& lattice) {
    side.amplification = largest_amplification(lattice, side.condition, wave_samples);
    side.growth = growth_of(model, 0, side.condition);
    const bool is_stabilised = find_vector_family(model.family).has_stabilisation;
    if (side.growth.growth <= growth_limit || !is_stabilised) {
        return;
    }
    for (const Rational& damping :
         {Rational(1, 100), Rational(1, 50), Rational(1, 20), Rational(1, 10), Rational(1, 5),
          Rational(1, 2), Rational(1), Rational(2)}) {
        if (growth_of(model, damping, side.condition).growth <= growth_limit) {
            side.damping = damping;
            return;
        }
    }
}

std::string grade_of(const GhostSide& side) {
    if (side.growth.growth > growth_limit) {
        return "grows";
    }
    if (side.amplification.value.alone <= sampled_limit) {
        return "contractive";
    }
    return side.amplification.value.paired <= sampled_limit ? "paired" : "amplifies";
}

std::string in_words(double amplification) {
    constexpr double unbounded = 1000;
    return amplification > unbounded ? "> 1000" : fmt::format("{:.3f}", amplification);
}

template <class Reflected>
std::string reflections(const PlaneLattice& lattice, Reflected reflected) {
    std::string text;
    for (const double angle : angles) {
        const double radians = angle * std::numbers::pi / 180;
        text += fmt::format("  {:.3f}/{:.3f}",
                            reflected(incident_wave(lattice, true, reflected_xi, radians)),
                            reflected(incident_wave(lattice, false, reflected_xi, radians)));
    }
    return text;
}

constexpr const char* row = "{:<24} {:<11} {:>10} {:>9} {:>5} {}\n";

std::string row_of(const GhostSide& side, const PlaneLattice& lattice, std::size_t reach) {
    const bool grows = side.growth.growth > growth_limit;
    return fmt::format(row, side.name, grade_of(side), in_words(side.amplification.value.paired),
                       grows ? fmt::format("{:.2g}", side.growth.growth) : "none",
                       side.damping ? to_string(*side.damping)
                       : grows      ? "-"
                                    : "0",
                       reflections(lattice, [&](const IncidentWave& wave) {
                           return reflected_in_plane(wave, side.condition, reach);
                       }));
}

std::string heading() {
    std::string text = fmt::format(row, "boundary", "grade", "round trip", "growth", "tau", "");
    text.pop_back();
    for (const double angle : angles) {
        text += fmt::format("  {:>7} deg", angle);
    }
    return text + "\n";
}

}  // namespace

std::string side_recommendation(const PlaneModel& model, const Progress& progress) {
    const VectorModel described = find_vector_family(model.family).describe(model.choice);
    const PlaneLattice lattice = plane_lattice(described, model.g, 0);
    std::vector<GhostSide> sides = ghost_sides(model, lattice);
    std::optional<PassiveSide> passive;
    std::atomic<std::size_t> done = 0;
    const std::size_t all = sides.size() + 1;
    progress(0, all);
    on_all_cores(all, [&](std::size_t i) {
        if (i == 0) {
            passive = passive_side(model);
        } else {
            examine(sides[i - 1], model, lattice);
        }
        progress(++done, all);
    });
    std::string table =
        heading() + fmt::format(row, "passive", "passive", "<= 1", "none", "0",
                                reflections(lattice, [&](const IncidentWave& wave) {
                                    return reflected_by_edge(passive->task, passive->edge, wave);
                                }));
    const std::size_t reach = lateral_chain(lattice, 0).reach();
    for (const GhostSide& side : sides) {
        table += row_of(side, lattice, reach);
    }
    return fmt::format(
        "passive, on the {} outermost layers of {}, g = {}\n"
        "  proved     no energy comes from it: in bodies of any shape, beside any side that adds "
        "none\n"
        "  steps      shorter by {:.2f} than the interior's where its layers are stiffer (1: "
        "no)\n\n"
        "{}\n"
        "grade: passive is proved; contractive (opposite any passive side), paired (opposite its "
        "like), amplifies and\n"
        "  grows were found on samples, {} x {} wave vectors and a strip of {} layers at {} wave "
        "numbers along it;\n"
        "  nothing is said of corners\n"
        "round trip: largest amplification of a wave by one reflection, over pairs of like sides\n"
        "growth: largest rate in the strip [c/dX, c = sqrt(E/density)]; tau: least damping tried "
        "that ends it\n"
        "degrees: from the normal; reflected energy of P/S, xi = {:g}/dX\n",
        passive->design.strain.size(), described.description, to_string(model.g),
        std::sqrt(std::max(1.0, passive->highest_eigenvalue_ratio)), table, wave_samples,
        wave_samples, layers, strip_wave_numbers + 1, reflected_xi);
}

}  // namespace nmbcgen
