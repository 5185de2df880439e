// SPDX-License-Identifier: MIT
/// The coefficients of the bonds of a chain (Alebrahim 2022, sections 4 and 6). Units: E = density
/// = dX = 1.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "generator/bonds/pi_polynomial.hpp"

namespace nmbcgen {

/// alpha of one bond: it scales the micromodulus 2 E/delta^2.
struct BondCoefficient {
    double value = 0;
    std::optional<PiPolynomial> closed_form{};
};

/// One that is given.
BondCoefficient rational_coefficient(const Rational& alpha);

/// How the coefficients of the chain are chosen. Each keeps (34), sum j alpha_j = N^2/2: long waves
/// have the speed 1. The residual is R = omega^2 - xi^2.
enum class ChainMethod {
    point,          ///< (40): R = 0 at m pi/(N - 1), m = 1 .. N - 1
    subdomain,      ///< (42), signed: the mean of R vanishes on N - 1 equal parts of 0 .. pi
    galerkin,       ///< (46), signed: R is orthogonal to 1 - cos(j xi), j = 1 .. N - 1
    least_squares,  ///< the least mean of R^2 on 0 .. pi
    taylor          ///< R is of the order 2N + 2 in xi
};

inline constexpr unsigned most_chain_bonds = 20;

/// alpha_1 .. alpha_N of omega^2 = sum_j 4 alpha_j/(N^2 j) (1 - cos(j xi)), (10), 1 <= N <=
/// most_chain_bonds. Exact where the equations are over Q[pi] or Q[pi, sqrt(d)]: always but for
/// point at N - 1 > 6 and subdomain at N - 1 = 5 and N - 1 > 6. Throws std::invalid_argument for
/// another N.
std::vector<BondCoefficient> chain_bonds(ChainMethod method, unsigned horizon);

/// (49): the integral of |R| on 0 .. pi, by 20 000 equal steps, whose error is below 1e-6 of it.
double residual_of_chain(std::span<const double> alpha);

/// The least and the largest of omega^2/xi^2 and omega over as many wave numbers: where the first
/// is below 0, waves grow.
struct ChainBand {
    double least_squared_speed = 0;
    double largest_frequency = 0;
};

ChainBand band_of_chain(std::span<const double> alpha);

}  // namespace nmbcgen
