// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen passive: a side of a plane lattice, or an end of a chain, that is stable by
/// construction.
#pragma once

#include <string>

#include "generator/families/vector_family.hpp"
#include "generator/passive/chain_end.hpp"

namespace nmbcgen {

/// A plane lattice at one g.
struct PlaneModel {
    std::string family;
    VectorChoice choice;
    Rational g;
    Rational time_step;  ///< of the steps it is for [dX sqrt(rho/E)]; 0: continuous time
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
    Rational time_step;  ///< of the steps it is for [dX/c]; 0: continuous time
};

/// Throws NoSuchBoundary where no design is found.
PassiveSide passive_end(const ChainModel& model);

/// An end as a C++ header: an nmbc::PassiveEnd.
std::string passive_header(const ChainModel& model);

/// Designs as JSON (docs/reference/json.md): all of it exact, and what they reflect.
std::string passive_json(const PlaneModel& model);
std::string passive_json(const ChainModel& model);

}  // namespace nmbcgen
