// SPDX-License-Identifier: GPL-2.0-or-later
/// Taylor coefficients -> matching boundary condition.
///
/// System (49) asks  s(xi) C(z) - B(z) = O(xi^{2N+1})  with C = sum c_j z^j, B = sum b_j z^j,
/// z = exp(i h xi), h the node spacing of the condition: B/C is the diagonal Pade approximant of
/// s at z = 1. A diagonal Pade approximant goes along with the Moebius map
/// y = (z - 1)/(z + 1) = tanh(i h xi / 2), so with w = y^p
///     C = (z + 1)^N P(w),   B = (z + 1)^N y Q(w),   s = y g(w),
/// Q/P is the [(N-1)/p over N/p] (integer parts) Pade approximant of g. Without damping s = i omega
/// is odd in y and p = 2: about N/2 unknowns in place of the 2N+2 of (49), and c symmetric, b
/// antisymmetric without being asked. With damping it is not odd, and p = 1.
#pragma once

#include <ginac/ginac.h>

#include <vector>

namespace nmbcgen {

/// C(z) and B(z), ascending powers, each N+1 coefficients, up to one common factor: c_j is
/// C[j]/C[0]. They are polynomials in whatever the Taylor coefficients are polynomials in.
struct MatchingPolynomials {
    std::vector<GiNaC::ex> C;
    std::vector<GiNaC::ex> B;
};

/// Why there is no condition at the given coefficients. All but vanishing_at_one make (49)
/// singular; that one is its only solution, of no use (unless c_0 = 0, too, which damping allows).
enum class Degeneracy {
    none,
    pade_block,        ///< no single approximant: every minor vanishes
    vanishing_at_one,  ///< C(1) = 0: a factor z - 1 or its square, and a Jordan block at s = 0
    lower_order,       ///< C and B share the factor z + 1: a condition of lower order
    pole,              ///< c_0 = 0, so that c_0 = 1 cannot be asked
};

/// The matching boundary condition of the given order >= 1.
/// taylor: a_0 .. a_{2N} at least, a_0 = 0; spacing: stride times dX.
/// Throws std::invalid_argument where taylor is too short or a_0 is not zero.
MatchingPolynomials match(const std::vector<GiNaC::ex>& taylor, const GiNaC::ex& spacing,
                          unsigned order);

/// Whether matching fails at these coefficients, and how. An order N condition that is found to
/// have a lower order satisfies (49) together with its multiples, so (49) is singular there.
Degeneracy degeneracy(const MatchingPolynomials& matching);

}  // namespace nmbcgen
