// SPDX-License-Identifier: MIT
/// Elimination of a second variable w: polynomials in w with coefficients in Q[G], ascending in w.
/// Zero coefficients at the end do not count; a polynomial without any other is zero.
#pragma once

#include <vector>

#include "generator/table/exact.hpp"

namespace nmbcgen {

/// The resultant with respect to w, the determinant of Sylvester's matrix:
///     a^n b^m prod (alpha_i - beta_k),
/// f of degree m, leading coefficient a and roots alpha_i, g of degree n with b and beta_k. It is
/// zero where and only where f and g have a common factor of degree > 0 in w, or one is zero.
/// Of a constant f it is f^n, of two constants 1.
///
/// Its value at a G where b vanishes but a does not is the resultant of the values of f and g
/// times a power of a; where both vanish it is zero, common factor or not.
///
/// Exact: by subresultants over Z at as many integers G as the degree in G can need, and Newton's
/// interpolation.
Polynomial resultant(const std::vector<Polynomial>& f, const std::vector<Polynomial>& g);

/// The polynomial of degree < number of points with the given values at them.
Polynomial interpolate(const std::vector<Integer>& points, std::vector<Rational> values);

/// A polynomial in w over Q, its coefficients as constants of Q[G].
std::vector<Polynomial> free_of_parameter(const Polynomial& in_w);

/// A polynomial in w at one G.
Polynomial at_parameter(const std::vector<Polynomial>& in_w, const Rational& G);

/// (-1)^(m(m-1)/2) resultant(f, df/dw)/a = a^(2m-2) prod_(i<k) (alpha_i - alpha_k)^2: zero where
/// and only where f has a multiple factor of degree > 0 in w. 1 at degree 1.
/// Throws std::domain_error where f is zero or constant in w.
Polynomial discriminant(const std::vector<Polynomial>& f);

}  // namespace nmbcgen
