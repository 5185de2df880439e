// SPDX-License-Identifier: GPL-2.0-or-later
/// Taylor coefficients -> matching boundary condition.
///
/// System (49) asks  i omega(xi) C(z) - B(z) = O(xi^{2N+1})  with C = sum c_j z^j, B = sum b_j z^j,
/// z = exp(i h xi), h the node spacing of the condition: B/C is the diagonal Pade approximant of
/// i omega at z = 1. A diagonal Pade approximant goes along with the Moebius map
/// y = (z - 1)/(z + 1) = tanh(i h xi / 2), and i omega is odd in y, so with w = y^2
///     C = (z + 1)^N P(w),   B = (z + 1)^N y Q(w),   i omega = y g(w),
/// Q/P is the [(N-1)/2 over N/2] (integer parts) Pade approximant of g: about N/2 unknowns in
/// place of the 2N+2 of (49), and c symmetric, b antisymmetric without being asked.
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
/// singular; that one is its only solution, of no use.
enum class Degeneracy {
    none,
    pade_block,        ///< no approximant at all: every minor vanishes
    vanishing_at_one,  ///< C(1) = 0: a factor (z-1)^2 and a Jordan block at s = 0
    lower_order,       ///< C and B share the factor z + 1: a condition of lower order
    pole,              ///< c_0 = 0, so that c_0 = 1 cannot be asked
};

/// The matching boundary condition of the given order >= 1.
/// taylor: a_0 .. a_{2N} at least, even ones zero; spacing: stride times dX.
/// Throws std::invalid_argument where taylor is too short or an even coefficient is not zero.
MatchingPolynomials match(const std::vector<GiNaC::ex>& taylor, const GiNaC::ex& spacing,
                          unsigned order);

/// Whether matching fails at these coefficients, and how. An order N condition that is found to
/// have a lower order satisfies (49) together with its multiples, so (49) is singular there.
Degeneracy degeneracy(const MatchingPolynomials& matching);

}  // namespace nmbcgen
