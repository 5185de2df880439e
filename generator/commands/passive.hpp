// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen passive: a side of a plane lattice, or an end of a chain, that is stable by
/// construction.
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

/// A designed side x = const, or an end, and what it is worth.
struct PassiveSide {
    EdgeTask task;
    PassiveDesign design;
    PassiveEdge edge;
    /// Of M^-1 K, in the interior or beside the edge, whichever is larger, as found at 33 wave
    /// numbers.
    double highest_eigenvalue = 0;
};

/// Larger families take minutes.
inline constexpr unsigned largest_side_radius_squared = 25;

inline constexpr double widest_designed_angle = 60;  ///< from the normal [degrees]

/// At an angle from the normal [degrees]. Throws NoSuchBoundary where it cannot be told from other
/// waves.
ArrivingWave wave_at(const PlaneLattice& lattice, bool is_P, double xi, double degrees);

/// Designed for P and S waves at angles up to the widest one with xi up to 1/dX, longer ones
/// counting more. Takes a second at radius 1, and 20 s at radius 3. Throws NoSuchBoundary where
/// such waves cannot be told from each other, or no design is found.
PassiveSide passive_side(const PlaneModel& model);

/// A chain nopd1d at one G.
struct ChainModel {
    unsigned horizon = 1;
    Rational G;
};

/// Designed for waves with xi up to 1/dX, longer ones counting more; what it reflects vanishes with
/// xi. Units dX = c = 1. Throws NoSuchBoundary where no design is found.
PassiveSide passive_end(const ChainModel& model);

/// Designs as JSON (docs/reference/json.md): all of it exact, and what they reflect.
std::string passive_json(const PlaneModel& model);
std::string passive_json(const ChainModel& model);

}  // namespace nmbcgen
