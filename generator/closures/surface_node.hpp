// SPDX-License-Identifier: MIT
/// The surface node method, a true end of a bond-based chain (SNM 2023): one node on the surface
/// tells the ghost nodes beyond it where to be. Units: dX = E = density = 1; displacements are
/// counted outwards; nodes lie at 1/2, 3/2, .. from the surface.
#pragma once

#include <vector>

#include "generator/table/exact.hpp"

namespace nmbcgen {

struct SurfaceNode {
    /// beta_1 .. beta_m of (2): bond k of the chain has the force beta_k (u_{i+k} - u_i)/(m k^2).
    std::vector<Rational> quadrature;
    /// (4): ghost f has the displacement 2f u_s - (2f - 1) u_1.
    std::vector<std::vector<Rational>> ghosts;  ///< factors of u_s and u_1, nearest ghost first
    /// (4) in (5), with the strain e that the traction would make: u_s = sum row u + load e.
    std::vector<Rational> row;  ///< of the nodes, nearest first; they sum to 1
    Rational load;
};

inline constexpr unsigned largest_closure_horizon = 100;

/// Of horizon m, 1 <= m <= largest_closure_horizon. corrected: beta_1 = 3/2, where 1 is printed:
/// the chain has the modulus 1 then, not 1 - 1/(2m), and is of second order in dX. Throws
/// std::invalid_argument for another horizon.
SurfaceNode surface_node(unsigned horizon, bool corrected);

}  // namespace nmbcgen
