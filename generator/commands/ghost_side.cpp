// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/ghost_side.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

#include "generator/families/projected.hpp"
#include "generator/families/vector_family.hpp"
#include "generator/names/projected_family.hpp"
#include "generator/pipeline.hpp"
#include "generator/plane/sampled_growth.hpp"
#include "generator/stability/half_space.hpp"

namespace nmbcgen {
namespace {

/// Samples reach 1 at the edges of bands, where waves stand, up to the roundings of a double root.
constexpr double sampled_limit = 1 + 1e-6;

bool grows(const PlaneLattice& lattice, const SideCondition& condition) {
    return strips_grow(lattice, condition, always(condition), side_samples.layers, 0) ||
           growth_with_corners(lattice, condition, 0) > 0;
}

std::string grade_of(const LargestAmplification& seen) {
    if (2 * seen.examined < seen.samples) {
        return "unknown";
    }
    if (seen.value.alone <= sampled_limit) {
        return "contractive";
    }
    return seen.value.paired <= sampled_limit ? "paired" : "amplifies";
}

bool is_of_stable(const std::string& grade) {
    return grade == "contractive" || grade == "paired";
}

/// Strips first, which tell most and take least time; boxes from the longest of the steps down.
double steps_of_grade(const PlaneLattice& lattice, const SideCondition& condition,
                      const std::string& grade) {
    const double longest = longest_step(lattice);
    const auto& shares = side_samples.steps;
    const auto* const end = std::ranges::find_if(shares, [&](double share) {
        const double dt = share * longest;
        return strips_grow(lattice, condition, always(condition), side_samples.layers, dt) ||
               grade_of(largest_amplification(lattice, condition, side_samples.waves, dt)) != grade;
    });
    const auto held =
        std::find_if(std::make_reverse_iterator(end), shares.rend(), [&](double share) {
            return growth_with_corners(lattice, condition, share * longest) == 0;
        });
    return held == shares.rend() ? 0 : *held;
}

/// Strips so narrow that a free side changes all of their layers are not looked at.
std::vector<std::string> growing_opposite(const SideTask& model, const PlaneLattice& lattice,
                                          const SideCondition& condition, double steps) {
    std::vector<std::pair<std::string, OppositeSide>> others{{"fixed", always(fixed_condition())}};
    if (const auto free = free_opposite(model)) {
        others.emplace_back("free", *free);
    }
    std::vector<std::string> names;
    for (const auto& [name, opposite] : others) {
        if (strips_grow(lattice, condition, opposite, side_samples.layers, 0) ||
            (steps > 0 && strips_grow(lattice, condition, opposite, side_samples.layers,
                                      steps * longest_step(lattice)))) {
            names.push_back(name);
        }
    }
    return names;
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
            condition.residual[is_P ? 0 : 1] = matching_residual(
                half_space.c, half_space.b, what.stride, is_P ? lattice.speed_P : lattice.speed_S);
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
        "{} nodes, steps of {:g} to {:g} times the longest in tenths",
        side_samples.waves, side_samples.waves + 1, fmt::join(side_samples.layers, ", "),
        strip_wave_numbers(side_samples.wave_numbers).size(), side_samples.nodes,
        side_samples.nodes, side_samples.steps.front(), side_samples.steps.back());
}

bool GhostSide::is_stable() const {
    return is_of_stable(grade_of(*this)) && steps > 0;
}

void examine(GhostSide& side, const SideTask& model, const PlaneLattice& lattice) {
    side.amplification = largest_amplification(lattice, side.condition, side_samples.waves);
    side.growth =
        growth_in_strips(lattice, side.condition, always(side.condition), side_samples.layers, 0);
    side.growth_with_corners = growth_with_corners(lattice, side.condition, 0);
    const std::string grade = grade_of(side);
    if (is_of_stable(grade)) {
        side.steps = steps_of_grade(lattice, side.condition, grade);
    }
    if (grade == "paired") {
        side.grows_opposite = growing_opposite(model, lattice, side.condition, side.steps);
    }
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
    return side.grows() ? "grows" : grade_of(side.amplification);
}

std::string opposite_of(const GhostSide& side) {
    if (!is_of_stable(grade_of(side))) {
        return "-";
    }
    if (grade_of(side) == "contractive") {
        return "any";
    }
    return side.grows_opposite.empty()
               ? "its like"
               : fmt::format("not {}", fmt::join(side.grows_opposite, ", "));
}

std::string steps_of(const GhostSide& side) {
    return !is_of_stable(grade_of(side)) ? "-"
           : side.steps > 0              ? fmt::format("{:.1f}", side.steps)
                                         : "none";
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
