// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/ghost_side.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "generator/families/projected.hpp"
#include "generator/families/vector_family.hpp"
#include "generator/names/projected_family.hpp"
#include "generator/pipeline.hpp"
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

/// 0 where it is roundings.
double growth_of(const PlaneLattice& lattice, const SideCondition& condition) {
    const double growth =
        largest_growth_in_strip(lattice, condition, side_samples.layers, side_samples.wave_numbers);
    constexpr std::size_t steps = 16;
    return growth > growth_limit * std::sqrt(highest_eigenvalue(lattice, steps)) ? growth : 0;
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

void examine(GhostSide& side, const SideTask& model, const PlaneLattice& lattice) {
    side.amplification = largest_amplification(lattice, side.condition, side_samples.waves);
    side.growth = growth_of(lattice, side.condition);
    const VectorFamily& family = find_vector_family(model.family);
    if (side.growth == 0 || !family.has_stabilisation) {
        return;
    }
    const VectorModel described = family.describe(model.choice);
    for (const Rational& damping :
         {Rational(1, 100), Rational(1, 50), Rational(1, 20), Rational(1, 10), Rational(1, 5),
          Rational(1, 2), Rational(1), Rational(2)}) {
        if (growth_of(plane_lattice(described, model.g, damping), side.condition) == 0) {
            side.damping = damping;
            return;
        }
    }
}

std::string grade_of(const GhostSide& side) {
    if (side.growth > 0) {
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
