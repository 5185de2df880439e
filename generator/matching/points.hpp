// SPDX-License-Identifier: GPL-2.0-or-later
/// Matching at wave numbers besides xi = 0.
///
/// The residual s(xi) C(z) - B(z) vanishes, with its derivatives below the multiplicity m, at each
/// matching point (the "particular wave length of interest" of Nicely 2018), and at xi = 0 in as
/// many rows of (49) as the order has left. In the variables of matching.hpp, C = (z+1)^N P(v),
/// B = (z+1)^N y Q(v), v = y^p, s = y g, it is rational interpolation in Hermite's sense,
///     g P - Q = O((x - x_p)^m),   x = cos xi,
/// linear in the coefficients of P and Q, P(0) = 1 (C(1) != 0). Without damping v = -tan^2(h xi/2)
/// and omega^2 are rational functions of x.
///
/// At a matching point the wave that comes in is matched: s = i omega where the group velocity is
/// positive, -i omega in a backward band.
#pragma once

#include "generator/table/table.hpp"

namespace nmbcgen {

/// Fills in c and b of a table at a fixed G that has its model and its Taylor coefficients.
/// They meet the rows at xi = 0 exactly, and the others to 40 digits or 80.
/// Throws NotMatched (local.hpp).
void match_at_points(Table& table);

}  // namespace nmbcgen
