// SPDX-License-Identifier: MIT
/// A square box of a plane lattice with corners.
#pragma once

#include <cstddef>

#include "generator/plane/side_condition.hpp"

namespace nmbcgen {

/// Conditions on its ghost layers. In the corners the ghosts follow the one across x, whose power
/// of D is not above that of the one across y.
struct BoxSides {
    SideCondition across_x;
    SideCondition across_y;
};

/// The largest real part of s [sqrt(E/rho)/dX] over all motions exp(s t) of a box of nodes x nodes
/// between these ghost layers, nodes even and no fewer than the layers inwards that a condition
/// looks at; in leapfrog steps of this length (leapfrog.hpp), or in continuous time, 0. x -> -x and
/// y -> -y are symmetries of the lattice. Positive where it is not stable; static states have
/// s = 0, up to the roundings of a multiple eigenvalue.
double growth_in_box(const PlaneLattice& lattice, const BoxSides& sides, std::size_t nodes,
                     double time_step = 0);

}  // namespace nmbcgen
