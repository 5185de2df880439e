// SPDX-License-Identifier: MIT
/// The real roots of polynomials over Q, as exact numbers.
#pragma once

#include <optional>
#include <vector>

#include "generator/table/algebraic.hpp"
#include "generator/table/exact.hpp"

namespace nmbcgen {

/// The polynomial with the same roots, each of them simple: it divided by its greatest common
/// divisor with its derivative. Throws std::domain_error where it is zero.
Polynomial square_free(const Polynomial& polynomial);

enum class Ends { closed, open };

/// How many different real roots the polynomial has between low and high, both ends counted or
/// neither; a missing end is infinite. 0 where high < low. By Sturm's theorem, which for a
/// square-free polynomial holds for roots at the ends, too: it counts those in (low, high].
/// Throws std::domain_error where the polynomial is zero.
std::size_t count_real_roots(const Polynomial& polynomial, const std::optional<Rational>& low,
                             const std::optional<Rational>& high, Ends ends = Ends::closed);

/// All different real roots in [low, high], or from low on where high is missing; ascending, in
/// disjoint intervals within those limits. Empty where high < low.
///
/// Roots are isolated by Sturm's theorem and bisection. A rational root of an integer polynomial
/// is a multiple of 1/a, a the leading coefficient (Gauss): once an interval is narrower than
/// that, one candidate is left, and it is tried. So it is for the sum and the product of the two
/// roots of a quadratic factor, whose candidate has to divide the polynomial; all pairs of real
/// roots are tried, wherever they lie.
/// Throws std::domain_error where the polynomial is zero.
std::vector<AlgebraicNumber> real_roots(const Polynomial& polynomial, const Rational& low,
                                        const std::optional<Rational>& high = std::nullopt);

}  // namespace nmbcgen
