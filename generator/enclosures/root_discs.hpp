// SPDX-License-Identifier: MIT
/// Discs that hold the roots of a polynomial known to within its coefficients.
#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <vector>

#include "generator/enclosures/interval.hpp"

namespace nmbcgen {

struct RootDisc {
    std::complex<double> centre;
    double radius;              ///< HUGE_VAL where nothing is known
    std::size_t component = 0;  ///< equal where discs hang together
};

/// The interval about a number that is exact.
ComplexInterval enclose(const std::complex<double>& z);

/// The square about a disc.
ComplexInterval box_about(const RootDisc& disc);

/// About approximations (Smith 1970): all roots of a polynomial of degree n with the leading
/// coefficient a are, for any n different z_i, in discs about z_i with radius n |f(z_i)/(a prod_{l
/// != i} (z_i - z_l))|; as many roots as discs in discs that hang together, anywhere in these. The
/// one alone about z_i is then f(z_i)/(a prod_{l != i} (z_i - x_l)) away from it, x_l the other
/// roots. This holds for every polynomial whose coefficients are in the intervals and whose values
/// are in value(z). Nothing where the leading coefficient may be 0.
std::vector<RootDisc> root_discs(
    const EnclosedPolynomial& f,
    const std::function<ComplexInterval(const ComplexInterval&)>& value);

}  // namespace nmbcgen
