// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen passive: a side of a plane lattice that is stable by construction.
#pragma once

#include <string>

#include "generator/families/vector_family.hpp"
#include "generator/passive/design.hpp"

namespace nmbcgen {

/// A plane lattice at one g.
struct PlaneModel {
    std::string family;
    VectorChoice choice;
    Rational g;
};

/// A designed side x = const, and what it is worth.
struct PassiveSide {
    EdgeTask task;
    PassiveDesign design;
    PassiveEdge edge;
    /// of M^-1 K, over the interior's: steps are shorter by its square root where it is over 1
    double highest_eigenvalue_ratio = 0;
};

inline constexpr double widest_designed_angle = 60;  ///< from the normal [degrees]

/// Designed for P and S waves at angles up to the widest one with xi up to 1/dX, longer ones
/// counting more. Takes a second at radius 1, and 20 s at radius 3. Throws NoProjection where long
/// waves of the model have no speed of their own.
PassiveSide passive_side(const PlaneModel& model);

/// The design as JSON (docs/reference/json.md): all of it exact, and what it reflects.
std::string passive_json(const PlaneModel& model);

}  // namespace nmbcgen
