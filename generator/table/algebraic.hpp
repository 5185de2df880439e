// SPDX-License-Identifier: MIT
/// Real algebraic numbers: where a condition on the stabilisation G begins or ceases to hold.
#pragma once

#include "generator/table/exact.hpp"

namespace nmbcgen {

/// The one real root of a polynomial in the closed interval [low, high].
///
/// The polynomial is primitive and square-free, its leading coefficient positive. A rational p/q
/// has the polynomial q x - p and low == high; a quadratic number has its irreducible quadratic
/// and, as any irrational one, low < its value < high. At degree 3 or more the polynomial need
/// not be irreducible, but none of its real roots is rational or quadratic. One number has many
/// intervals, so that equality is a matter of compare(), exact/algebraic_number.hpp;
/// exact/real_roots.hpp makes these numbers.
struct AlgebraicNumber {
    IntegerPolynomial polynomial;
    Rational low;
    Rational high;
};

}  // namespace nmbcgen
