// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/ghost_side.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "generator/families/projected.hpp"
#include "generator/families/vector_family.hpp"
#include "generator/names/projected_family.hpp"
#include "generator/pipeline.hpp"
#include "generator/plane/box.hpp"
#include "generator/plane/strip.hpp"
#include "generator/stability/half_space.hpp"

namespace nmbcgen {
namespace {

/// Z in place of Z^stride.
std::vector<double> spread(const std::vector<double>& coefficients, std::size_t stride,
                           double factor) {
    std::vector<double> spread(stride * (coefficients.size() - 1) + 1);
    for (std::size_t j = 0; j < coefficients.size(); ++j) {
        spread[stride * j] = factor * coefficients[j];
    }
    return spread;
}

/// Over the highest frequency: roundings of the eigenvalues of some hundred states.
constexpr double growth_limit = 1e-9;
/// Samples reach 1 at the edges of bands, where waves stand, up to the roundings of a double root.
constexpr double sampled_limit = 1 + 1e-6;

/// How many layers inwards its ghost layers look.
std::size_t width_of(const SideCondition& condition) {
    std::size_t width = 0;
    for (const ShiftPolynomial& residual : condition.residual) {
        for (const std::vector<double>& shifts : residual) {
            width = std::max(width, shifts.size() - 1);
        }
    }
    return width;
}

/// 0 where it is roundings.
double told_growth(double growth, const PlaneLattice& lattice) {
    constexpr std::size_t steps = 16;
    return growth > growth_limit * std::sqrt(highest_eigenvalue(lattice, steps)) ? growth : 0;
}

double growth_between_two(const PlaneLattice& lattice, const SideCondition& condition,
                          std::size_t layers) {
    return told_growth(
        largest_growth_in_strip(lattice, condition, std::max(layers, width_of(condition)),
                                side_samples.wave_numbers),
        lattice);
}

double growth_between_four(const PlaneLattice& lattice, const SideCondition& condition) {
    const std::size_t even = 2 * ((width_of(condition) + 1) / 2);
    return told_growth(growth_in_box(lattice, {.across_x = condition, .across_y = condition},
                                     std::max(side_samples.nodes, even)),
                       lattice);
}

bool grows(const PlaneLattice& lattice, const SideCondition& condition) {
    return growth_between_four(lattice, condition) > 0 ||
           std::ranges::any_of(side_samples.layers, [&](std::size_t layers) {
               return growth_between_two(lattice, condition, layers) > 0;
           });
}

}  // namespace

std::optional<SideCondition> component_condition(const SideTask& model, const PlaneLattice& lattice,
                                                 Specification what) {
    SideCondition condition;
    what.horizon = horizon_of(model.choice);
    for (const Polarisation polarisation : {Polarisation::P, Polarisation::S}) {
        const bool is_P = polarisation == Polarisation::P;
        what.family =
            name_of({.family = model.family, .model = model.choice, .polarisation = polarisation});
        try {
            const HalfSpace half_space = make_half_space(derive(what), model.g);
            condition.residual[is_P ? 0 : 1] = {
                spread(half_space.b, what.stride, is_P ? -lattice.speed_P : -lattice.speed_S),
                spread(half_space.c, what.stride, 1)};
        } catch (const NoSuchBoundary&) {
            return std::nullopt;
        } catch (const std::domain_error&) {  // a pole
            return std::nullopt;
        }
    }
    return condition;
}

std::string component_name(unsigned order, unsigned stride) {
    return fmt::format("NMBC{} by component{}", order,
                       stride == 1 ? "" : fmt::format(", s = {}", stride));
}

std::string samples_text() {
    return fmt::format(
        "{} x {} wave vectors, strips of {} layers with {} wave numbers along them, a box of {} x "
        "{} nodes",
        side_samples.waves, side_samples.waves + 1, fmt::join(side_samples.layers, ", "),
        strip_wave_numbers(side_samples.wave_numbers).size(), side_samples.nodes,
        side_samples.nodes);
}

void examine(GhostSide& side, const SideTask& model, const PlaneLattice& lattice) {
    side.amplification = largest_amplification(lattice, side.condition, side_samples.waves);
    side.growth = 0;
    for (const std::size_t layers : side_samples.layers) {
        side.growth = std::max(side.growth, growth_between_two(lattice, side.condition, layers));
    }
    side.growth_with_corners = growth_between_four(lattice, side.condition);
    const VectorFamily& family = find_vector_family(model.family);
    if (!side.grows() || !family.has_stabilisation) {
        return;
    }
    const VectorModel described = family.describe(model.choice);
    for (const Rational& damping :
         {Rational(1, 100), Rational(1, 50), Rational(1, 20), Rational(1, 10), Rational(1, 5),
          Rational(1, 2), Rational(1), Rational(2)}) {
        if (!grows(plane_lattice(described, model.g, damping), side.condition)) {
            side.damping = damping;
            return;
        }
    }
}

std::string grade_of(const GhostSide& side) {
    if (side.grows()) {
        return "grows";
    }
    const LargestAmplification& seen = side.amplification;
    if (2 * seen.examined < seen.samples) {
        return "unknown";
    }
    if (side.amplification.value.alone <= sampled_limit) {
        return "contractive";
    }
    return side.amplification.value.paired <= sampled_limit ? "paired" : "amplifies";
}

std::string amplification_of(const GhostSide& side) {
    constexpr double unbounded = 1000;
    const auto& [alone, paired] = side.amplification.value;
    if (paired > unbounded) {
        return "> 1000";
    }
    constexpr double many = 10;
    return fmt::format("{}{:.{}f}", side.condition.is_shared() ? "" : "<= ", paired,
                       paired > many ? 0 : 3);
}

}  // namespace nmbcgen
