// SPDX-License-Identifier: MIT
/// Exact numbers: the types every stage behind the freeze gate computes with.
#pragma once

#include <boost/math/tools/polynomial.hpp>
#include <boost/multiprecision/gmp.hpp>

namespace nmbcgen {

using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

/// Polynomials in the stabilisation G, coefficients in ascending powers; zero has none.
using Polynomial = boost::math::tools::polynomial<Rational>;
using IntegerPolynomial = boost::math::tools::polynomial<Integer>;

/// A rational function of G in its one normal form: integer coefficients, numerator and
/// denominator without a common factor (polynomial or integer), leading denominator
/// coefficient positive. Zero is 0/1. exact/rational_function.hpp makes them.
struct ExactFunction {
    IntegerPolynomial numerator;
    IntegerPolynomial denominator;

    friend bool operator==(const ExactFunction& left, const ExactFunction& right) {
        return left.numerator == right.numerator && left.denominator == right.denominator;
    }
};

}  // namespace nmbcgen
