// SPDX-License-Identifier: MIT
/// The band omega^2(xi) of a lattice as a polynomial in x = cos xi.
#pragma once

#include <vector>

#include "generator/table/exact.hpp"

namespace nmbcgen {

/// Ascending in x = cos xi, coefficients in Q[G].
using InX = std::vector<Polynomial>;

/// omega^2 = symbol_0 + 2 sum symbol_m T_m(x), without zeros at the end.
InX band(const std::vector<Polynomial>& symbol);

InX derivative(const InX& polynomial);

/// The value at x, a polynomial in G.
Polynomial at(const InX& polynomial, int x);

/// left + factor * right
InX plus(const InX& left, const InX& right, const Polynomial& factor);

InX times_x(const InX& polynomial);

InX times(const InX& left, const InX& right);

/// A polynomial at the quotient of two others, times denominator^degree, which is not less than its
/// own: sum_i f_i numerator^i denominator^(degree-i).
InX at_quotient(const InX& f, std::size_t degree, const InX& numerator, const InX& denominator);

/// Removes zeros at the end.
void trim(InX& polynomial);

}  // namespace nmbcgen
