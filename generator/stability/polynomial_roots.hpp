// SPDX-License-Identifier: MIT
/// Roots of polynomials in doubles. Coefficients by ascending powers.
#pragma once

#include <complex>
#include <vector>

#include "generator/table/exact.hpp"

namespace nmbcgen {

/// All complex roots. Leading coefficients that are exactly 0 do not count.
std::vector<std::complex<double>> polynomial_roots(const std::vector<double>& coefficients);
std::vector<std::complex<double>> polynomial_roots(
    const std::vector<std::complex<double>>& coefficients);

/// Likewise; guesses: the roots of a polynomial next to it, or none.
std::vector<std::complex<double>> polynomial_roots(
    const std::vector<std::complex<double>>& coefficients,
    const std::vector<std::complex<double>>& guesses);

/// The roots other than 0 of an exact polynomial.
std::vector<std::complex<double>> nonzero_roots(const Polynomial& polynomial);
std::vector<std::complex<double>> nonzero_roots(const IntegerPolynomial& polynomial);

/// Of a polynomial that is not empty.
std::vector<double> derivative(const std::vector<double>& coefficients);

template <class Number>
struct ValueAndSlope {
    Number value{0};
    Number slope{0};
};

template <class Scalar, class Number>
ValueAndSlope<Number> evaluate_with_slope(const std::vector<Scalar>& coefficients,
                                          const Number& x) {
    ValueAndSlope<Number> at_x;
    for (std::size_t i = coefficients.size(); i-- > 0;) {
        at_x.slope = at_x.slope * x + at_x.value;
        at_x.value = at_x.value * x + coefficients[i];
    }
    return at_x;
}

/// A step or three of Newton's on sum_i a_i x^i from x, as long as they help.
template <class Scalar>
std::complex<double> polished(const std::vector<Scalar>& a, std::complex<double> x) {
    ValueAndSlope<std::complex<double>> here = evaluate_with_slope(a, x);
    for (int i = 0; i < 3 && here.slope != 0.0; ++i) {
        const std::complex<double> next = x - here.value / here.slope;
        const ValueAndSlope<std::complex<double>> there = evaluate_with_slope(a, next);
        if (std::norm(there.value) >= std::norm(here.value)) {
            break;
        }
        x = next;
        here = there;
    }
    return x;
}

}  // namespace nmbcgen
