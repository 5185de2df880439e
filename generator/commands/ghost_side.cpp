// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/ghost_side.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

std::vector<std::string> growing_opposite(const GhostSide& side, const SideTask& model,
                                          const PlaneLattice& lattice) {
    std::vector<std::pair<std::string, OppositeSide>> others{{"fixed", always(fixed_condition())}};
    if (const auto free = free_opposite(model)) {
        others.emplace_back("free", *free);
    }
    std::vector<std::string> names;
    for (const auto& [name, opposite] : others) {
        if (grows_opposite(side, lattice, opposite)) {
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

void examine(GhostSide& side, const SideTask& model, const PlaneLattice& lattice) {
    sample_side(side, lattice);
    if (grade_of(side) == "paired") {
        side.grows_opposite = growing_opposite(side, model, lattice);
    }
    const VectorFamily& family = find_vector_family(model.family);
    if (!side.grows() || !family.has_stabilisation) {
        return;
    }
    const VectorModel described = family.describe(model.choice);
    for (const Rational& damping :
         {Rational(1, 100), Rational(1, 50), Rational(1, 20), Rational(1, 10), Rational(1, 5),
          Rational(1, 2), Rational(1), Rational(2)}) {
        if (!grows_in_lattice(plane_lattice(described, model.g, damping), side.condition)) {
            side.damping = damping;
            return;
        }
    }
}

std::string opposite_of(const GhostSide& side) {
    if (!side.is_stable_in_continuous_time()) {
        return "-";
    }
    if (grade_of(side) == "contractive") {
        return "any";
    }
    return side.grows_opposite.empty()
               ? "its like"
               : fmt::format("no {}", fmt::join(side.grows_opposite, ", no "));
}

std::string steps_of(const GhostSide& side) {
    return !side.is_stable_in_continuous_time() ? "-"
           : side.steps > 0                     ? fmt::format("{:.1f}", side.steps)
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
