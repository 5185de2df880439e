// SPDX-License-Identifier: MIT
/// What the waves obey that decay from a boundary by themselves. With sigma = B/C from the boundary
/// condition, the interior's equation (half_space.hpp) is
///     B^2 + tau sigma(k) B (C - B dt/2) + omega^2(k) (C^2 - B^2 dt^2/4) = 0.
#pragma once

#include <array>

#include "generator/stability/half_space.hpp"

namespace nmbcgen {

/// Its left side times (1-w)^r (1-y)^{2Ns}, exact and up to one positive factor: a polynomial in y
/// of a damped lattice, in w of an undamped one, where C is even in y and B odd.
IntegerPolynomial mode_polynomial(const HalfSpace& half_space);

/// Its coefficients by powers of dt/2, which serve every step of one half space.
std::array<IntegerPolynomial, 3> mode_coefficients(const HalfSpace& half_space);

/// C(k) and B(k) times (1-y)^{Ns}, in y.
Polynomial C_in_y(const HalfSpace& half_space);
Polynomial B_in_y(const HalfSpace& half_space);

}  // namespace nmbcgen
