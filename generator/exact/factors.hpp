// SPDX-License-Identifier: MIT
/// Factors of polynomials over Q, for people to read.
#pragma once

#include <vector>

#include "generator/table/exact.hpp"

namespace nmbcgen {

struct Factor {
    IntegerPolynomial polynomial;  ///< primitive, not constant, the leading coefficient positive
    unsigned power;
};

/// content * product of factor^power, in order of degree, then of the coefficients from the top.
struct Factors {
    Rational content;
    std::vector<Factor> factors;
};

/// Takes out all rational linear factors and all quadratic ones with real roots; what is left
/// is one factor more, whether it is irreducible or not. Throws std::domain_error for zero.
Factors factors_of(const Polynomial& polynomial);

}  // namespace nmbcgen
