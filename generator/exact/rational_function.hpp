// SPDX-License-Identifier: MIT
/// Polynomials and rational functions of one parameter, over Q.
#pragma once

#include <vector>

#include "generator/table/exact.hpp"

namespace nmbcgen {

/// numerator/denominator in the normal form of ExactFunction.
/// Throws std::domain_error where denominator is zero.
ExactFunction reduce(const Polynomial& numerator, const Polynomial& denominator);

/// A polynomial over Q as a rational function: the same, over the common denominator.
ExactFunction to_rational_function(const Polynomial& polynomial);

/// The same coefficients over Q.
Polynomial over_rationals(const IntegerPolynomial& polynomial);

/// The least common denominator of its coefficients.
Integer common_denominator(const Polynomial& polynomial);

/// polynomial * multiple, where multiple is one of its common denominator.
IntegerPolynomial over_integers(const Polynomial& polynomial, const Integer& multiple);

/// (1 + sign x)^power
IntegerPolynomial binomial(int sign, std::size_t power);

/// The constant polynomial.
Polynomial constant(const Rational& value);

/// The value at the given argument. The second throws std::domain_error at a pole.
Rational evaluate(const Polynomial& polynomial, const Rational& argument);
Rational evaluate(const ExactFunction& function, const Rational& argument);

/// The product of the distinct denominators, so that every member times it is a polynomial;
/// not always the least such polynomial.
Polynomial common_denominator(const std::vector<ExactFunction>& functions);

/// function * multiple as a polynomial, where multiple is a multiple of its denominator.
/// Throws std::logic_error where it is not.
Polynomial times_multiple(const ExactFunction& function, const Polynomial& multiple);

}  // namespace nmbcgen
