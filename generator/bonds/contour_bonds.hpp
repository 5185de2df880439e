// SPDX-License-Identifier: MIT
/// The methods of Alebrahim 2022, section 6, for a square lattice: residuals along the contour of
/// the irreducible Brillouin zone, O (0, 0) to M (pi, 0) to Y (pi, pi) to O.
#pragma once

#include "generator/bonds/bond_method.hpp"
#include "generator/bonds/square_lattice.hpp"

namespace nmbcgen {

/// With the exact speeds of long waves, (39), and as many equations more as there are classes of
/// bonds but two: (41), (43), (45) or (47). By symmetry waves on the contour have the same
/// polarisations whatever the coefficients, in which omega^2 is linear. Places and parts are equal
/// in arc length, in which means are taken, too; (41) prints the places O, M, Y instead. Galerkin's
/// functions are those of all classes but the two longest.
///
/// Family radius N dX, 2 <= N <= most_square_bonds. Throws NoSuchBonds where the equations are
/// singular: `point`, `subdomain` and `galerkin` from N = 5 on, as six classes there add linearly
/// dependent functions to R. Throws std::invalid_argument for `taylor` and `bz_ls`.
SquareBonds contour_bonds(BondMethod method, unsigned horizon);

}  // namespace nmbcgen
