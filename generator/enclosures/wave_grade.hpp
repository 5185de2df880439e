// SPDX-License-Identifier: MIT
/// Whether a boundary amplifies no wave of one frequency, at every G and every step of a box.
///
/// Let x_1 > .. > x_m be the cosines of the waves that travel at one frequency omega (forwards,
/// backwards, forwards, ..), Omega = omega/sqrt(1 - omega^2 dt^2/4), C~ and B~ real trigonometric
/// polynomials with C = k^{Ns/2} C~ and B = i k^{Ns/2} B~, and f[..] a divided difference. Then
/// (docs/explanation/theorems.md), with Q and R polynomials, deg Q <= (m-1)/2 and deg R <= (m-2)/2,
///   - sup over phases of rho(R D) <= 1 (paired) if and only if for all Q and R
///         [x_1 .. x_m] p T h Q^2 >= 0 and [x_1 .. x_m] q T h R^2 >= 0,
///     h = 1/max(C~^2, B~^2/Omega^2);
///   - sigma_max(R) <= 1 (contractive) if and only if for all Q and R
///         [x_1 .. x_m] (Omega T (p Q^2 + q R^2) - (Omega^2 C~^2 + B~^2) Q R) >= 0;
/// T = C~ B~/sin xi, p = 1 and q = 1 - x^2 where m is odd, 1 + x and 1 - x where it is even.
/// What decays from the boundary does not count, and where two waves meet and are no more, a
/// divided difference becomes a derivative: nothing here is singular at the edges of the band.
#pragma once

#include <cstddef>
#include <vector>

#include "generator/enclosures/condition.hpp"

namespace nmbcgen {

/// Some of the waves of one frequency, not told apart.
struct WaveGroup {
    Interval where;  ///< of their cosines
    std::size_t count;
};

/// groups: all waves that travel, in any order; seen_squared: Omega^2. False where it is
/// undecided, too.
bool is_contractive(const EnclosedCondition& condition, const std::vector<WaveGroup>& groups,
                    const Interval& seen_squared);
bool is_paired(const EnclosedCondition& condition, const std::vector<WaveGroup>& groups,
               const Interval& seen_squared);

}  // namespace nmbcgen
