// SPDX-License-Identifier: MIT
/// A passive side of a plane lattice.
#pragma once

#include <array>
#include <nmbc/plane_sides.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "generator/passive/design.hpp"
#include "generator/passive/side_layers.hpp"
#include "generator/plane/sampled_growth.hpp"
#include "generator/table/vector_model.hpp"

namespace nmbcgen {

/// A plane lattice at one g, and what a side of it is to be.
struct SideTask {
    std::string family;
    VectorChoice choice;
    Rational g;
    Rational time_step;  ///< of the steps it is for [dX sqrt(rho/E)]; 0: continuous time
    /// Whether the body may have one: beside a free side it must not.
    bool has_null_lagrangian = true;
    std::size_t layers = 0;  ///< with numbers of their own; 0: twice the horizon, the fewest
};

/// All of it, in one line.
std::string words_of(const SideTask& side);

/// Larger families take minutes.
inline constexpr unsigned largest_side_radius_squared = 25;

/// From the normal [degrees].
double widest_designed_angle(const DesignedSide& side);

/// At an angle from the normal [degrees]. Throws std::domain_error where it cannot be told from
/// other waves.
ArrivingWave wave_at(const PlaneLattice& lattice, bool is_P, double xi, double degrees);

/// Designed for P and S waves at angles up to the widest one with xi up to 1/dX, longer ones
/// counting more. Takes less than a second at radius 1, and 10 s at radius 3; 16 layers take half a
/// minute. Throws std::domain_error where such waves cannot be told from each other, or no design
/// is found.
DesignedSide passive_side(const SideTask& model, const DesignProgress& progress = {});

/// A free side of the undamped lattice, as strips have it opposite another one; nothing of a family
/// without energies at an edge.
std::optional<OppositeSide> free_opposite(const SideTask& model);

/// Of the waves of reflected_by_side() [1/dX]. At one of them alone a design may send back much
/// less than beside it.
inline constexpr std::array long_waves{0.05, 0.1, 0.2};

/// Of long waves at each of these angles from the normal [degrees]: the part of the energy that
/// comes back, of P or S waves of any of the three lengths, whichever is largest. Throws as
/// wave_at().
std::vector<double> reflected_by_side(const SideTask& model, const DesignedSide& side,
                                      std::span<const double> degrees);

/// The side as the runtime takes it.
nmbc::PassiveSide for_runtime(const DesignedSide& side);

}  // namespace nmbcgen
