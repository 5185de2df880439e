// SPDX-License-Identifier: GPL-2.0-or-later
/// Conditions on the ghost layers of a side of a plane lattice, and what is found of them on
/// samples.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/passive/plane_side.hpp"
#include "generator/plane/side_condition.hpp"
#include "generator/plane/side_reflection.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// A boundary of ghost layers and what was found of it.
struct GhostSide {
    std::string name;
    SideCondition condition;
    LargestAmplification amplification{};
    double growth = 0;               ///< rate in strips [sqrt(E/rho)/dX]; 0 where it is roundings
    double growth_with_corners = 0;  ///< in a box; likewise
    std::optional<Rational> damping{};  ///< the smallest tau tried with which neither grows
    /// The largest leapfrog step, over the longest one, in which the grade is what it is in
    /// continuous time, as in all shorter ones that are looked at; 0: none, or not sought.
    double steps = 0;
    /// Opposite which sides strips grow: "fixed", "free".
    std::vector<std::string> grows_opposite{};

    bool grows() const { return growth > 0 || growth_with_corners > 0; }
    bool is_stable() const;  ///< contractive or paired, in steps too
};

/// Of sides, in words: "24 x 25 wave vectors, strips of ..".
std::string samples_text();

/// NMBC, component by component, from the chains that P and S waves along x see; nothing where
/// there is none at this g. what: all but its family and horizon; a condition that is matched in
/// steps is looked at in continuous time.
std::optional<SideCondition> component_condition(const SideTask& model, const PlaneLattice& lattice,
                                                 Specification what);

/// "NMBC2 by component, s = 3"
std::string component_name(unsigned order, unsigned stride);

/// Finds how the side amplifies waves and whether strips of the lattice grow between two of them,
/// or a box between four; where one does, the damping that ends it in all of them, in continuous
/// time; where none does, in which steps, and opposite which sides.
void examine(GhostSide& side, const SideTask& model, const PlaneLattice& lattice);

/// "grows", "amplifies", "paired", "contractive", or "unknown" where most waves cannot be told.
std::string grade_of(const GhostSide& side);

/// "any", "its like", or what else the side may face; "-" where it grows or amplifies.
std::string opposite_of(const GhostSide& side);

/// "0.9", of the longest step; "none", or "-" where it grows or amplifies in continuous time.
std::string steps_of(const GhostSide& side);

/// The largest amplification between two like sides, or a bound: "<= 1.1".
std::string amplification_of(const GhostSide& side);

}  // namespace nmbcgen
