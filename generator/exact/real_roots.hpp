// SPDX-License-Identifier: GPL-2.0-or-later
/// The real roots of polynomials over Q, and the exact numbers they are. Nothing here rounds but
/// nearest_double().
#pragma once

#include <compare>
#include <optional>
#include <string>
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

/// A rational as an algebraic number.
AlgebraicNumber to_algebraic_number(const Rational& value);

/// Narrows the interval to high - low <= width; rational numbers have width 0 already. By secants
/// on ever finer grids, or bisection where they miss (Abbott, Quadratic interval refinement).
/// Throws std::invalid_argument where width is not positive.
void refine(AlgebraicNumber& number, const Rational& width);

/// The nearest double. An irrational number is never half-way between two doubles, so that
/// refinement decides; rational ones are rounded exactly, ties to even.
/// Throws std::overflow_error where that is infinity.
double nearest_double(const AlgebraicNumber& number);

/// Exact: two numbers are equal where the greatest common divisor of their polynomials has a root
/// in both intervals; others come apart by refinement.
std::strong_ordering compare(const AlgebraicNumber& left, const AlgebraicNumber& right);
std::strong_ordering compare(const AlgebraicNumber& left, const Rational& right);

/// -1, 0 or 1: the sign of polynomial(number). Zero by the greatest common divisor with the
/// number's own polynomial; otherwise refined until the interval is free of roots.
int sign_at(const Polynomial& polynomial, const AlgebraicNumber& number);

/// The rational of the least denominator strictly between two different numbers, in either
/// order; of several, the one nearest to zero. It does not depend on the numbers' intervals.
/// Throws std::invalid_argument where the numbers are equal.
Rational rational_between(const AlgebraicNumber& one, const AlgebraicNumber& other);

/// Likewise above the number: zero, or the next integer above a number >= 0.
Rational rational_above(const AlgebraicNumber& number);

/// "p/q" or "p" for a rational number; a radical such as "2 - sqrt(2)", "-3*sqrt(2)/2" or
/// "(5584 - 80*sqrt(433))/4335" for a quadratic one; empty for any other.
///
/// The fraction is in lowest terms. The radicand has no square factor of a prime below 10^6, and
/// none at all below 10^18; larger primes are looked for no further than a perfect square.
std::string to_text(const AlgebraicNumber& number);

}  // namespace nmbcgen
