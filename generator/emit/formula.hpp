// SPDX-License-Identifier: MIT
/// Closed forms as formulas, in plain text or LaTeX.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/table/algebraic.hpp"
#include "generator/table/closed_forms.hpp"

namespace nmbcgen {

enum class Notation { text, latex };

/// 3n^2 + 3n - 1, by descending powers of the letter; "0" of the zero polynomial.
std::string formula(const IntegerPolynomial& polynomial, std::string_view letter,
                    Notation notation);

/// The terms of sum_g p_g(n) (G/n^pole)^g that are not zero, ascending in g; each begins with its
/// sign, "+ " or "- ". One fraction a term, its numerator in factors.
std::vector<std::string> terms(const ClosedForm& function, unsigned pole, Notation notation);

/// "= 1/4", or of an irrational number without a radical "= 1.846147614, a root of .. = 0".
std::string value(const AlgebraicNumber& number, std::string_view letter, Notation notation);

/// (2G - 1) W + 1 = 0: a polynomial in W with coefficients in Z[G].
std::string equation(const std::vector<Polynomial>& in_W, Notation notation);

}  // namespace nmbcgen
