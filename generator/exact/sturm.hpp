// SPDX-License-Identifier: MIT
/// Integer polynomials and Sturm's theorem: what real_roots.hpp and algebraic_number.hpp share.
#pragma once

#include <vector>

#include "generator/table/algebraic.hpp"
#include "generator/table/exact.hpp"

namespace nmbcgen {

/// The integer polynomial with the same roots, primitive, the leading coefficient positive.
IntegerPolynomial primitive(const Polynomial& polynomial);

/// primitive(polynomial / divisor), where divisor divides it.
IntegerPolynomial quotient(const IntegerPolynomial& polynomial, const IntegerPolynomial& divisor);

/// The primitive polynomial with the same roots, each of them simple.
/// Throws std::domain_error where it is zero.
IntegerPolynomial primitive_square_free(const Polynomial& polynomial);

/// q^degree times the value at x = p/q, which needs no fractions.
Integer scaled_value(const IntegerPolynomial& polynomial, const Rational& x);

/// -1, 0 or 1: the sign of the value at x.
int sign_of(const IntegerPolynomial& polynomial, const Rational& x);

/// Whether the signs at the ends of the number's interval differ.
bool changes_sign(const IntegerPolynomial& polynomial, const AlgebraicNumber& between);

/// Sturm's chain of a square-free polynomial, its members up to positive factors.
class SturmChain {
  public:
    explicit SturmChain(const IntegerPolynomial& polynomial);

    /// The changes of sign along the chain; (x, y] holds changes(x) - changes(y) roots.
    std::size_t changes(const Rational& x) const;

    std::size_t roots_in_closed(const Rational& low, const Rational& high) const;

  private:
    std::vector<IntegerPolynomial> chain_;
};

}  // namespace nmbcgen
