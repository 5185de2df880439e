// SPDX-License-Identifier: GPL-2.0-or-later
/// Conditions on the ghost layers of a side of a model: how they are made, what is found of them
/// with the model's damping and its free sides, and all of it in words.
#pragma once

#include <optional>
#include <string>

#include "generator/passive/plane_side.hpp"
#include "generator/plane/sampled_side.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// Of sides, in words: "24 x 25 wave vectors, strips of ..".
std::string samples_text();

/// NMBC, component by component, from the chains that P and S waves along x see; nothing where
/// there is none at this g. what: all but its family and horizon; a condition that is matched in
/// steps is looked at in continuous time.
std::optional<SideCondition> component_condition(const SideTask& model, const PlaneLattice& lattice,
                                                 Specification what);

/// "NMBC2 by component, s = 3"
std::string component_name(unsigned order, unsigned stride);

/// Samples the side, and finds where it grows the damping that ends it, in continuous time, and
/// where it is paired opposite which sides strips grow.
void examine(GhostSide& side, const SideTask& model, const PlaneLattice& lattice);

/// "any", "its like", or what else the side may face; "-" where it grows or amplifies.
std::string opposite_of(const GhostSide& side);

/// "0.9", of the longest step; "none", or "-" where it grows or amplifies in continuous time.
std::string steps_of(const GhostSide& side);

/// The largest amplification between two like sides, or a bound: "<= 1.1".
std::string amplification_of(const GhostSide& side);

}  // namespace nmbcgen
