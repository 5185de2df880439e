// SPDX-License-Identifier: MIT
/// Whether no wave is amplified at any frequency of the band, at every G and every step of a box.
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

#include "generator/enclosures/condition.hpp"
#include "generator/table/certificate.hpp"

namespace nmbcgen {

/// tau: as in condition.hpp. By subdivision of the frequencies and of tau into boxes, at most so
/// many; false where that is undecided.
bool waves_have_grade(const EnclosedCondition& condition, const Interval& tau, Grade least,
                      int most_boxes);

/// The largest value of the band.
Interval highest_square(const EnclosedPolynomial& band);

/// How far the band is unknown, in parts of its largest value: finer subdivision does not help.
double spread_of(const EnclosedPolynomial& band);

}  // namespace nmbcgen
