// SPDX-License-Identifier: MIT
/// Operations on real algebraic numbers. Nothing here rounds but nearest_double().
#pragma once

#include <compare>
#include <string>

#include "generator/table/algebraic.hpp"
#include "generator/table/exact.hpp"

namespace nmbcgen {

/// A rational as an algebraic number.
AlgebraicNumber to_algebraic_number(const Rational& value);

/// Whether the interval is a point, as it is for rational numbers alone.
bool is_rational(const AlgebraicNumber& number);

/// Replaces an end of the interval by the point, if it lies in between; where it is the root, the
/// number becomes the point.
void cut(AlgebraicNumber& number, const Rational& point);

/// Halves the interval.
void halve(AlgebraicNumber& number);

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
