// SPDX-License-Identifier: MIT
/// The coefficients of the bonds of a chain (Alebrahim 2022, sections 4 and 6). Units: E = density
/// = dX = 1.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "generator/bonds/bond_method.hpp"
#include "generator/bonds/pi_polynomial.hpp"

namespace nmbcgen {

/// alpha of one bond: it scales the micromodulus 2 E/delta^2.
struct BondCoefficient {
    double value = 0;
    std::optional<PiPolynomial> closed_form{};
};

/// One that is given.
BondCoefficient rational_coefficient(const Rational& alpha);

inline constexpr unsigned most_chain_bonds = 20;

/// alpha_1 .. alpha_N of omega^2 = sum_j 4 alpha_j/(N^2 j) (1 - cos(j xi)), (10), 1 <= N <=
/// most_chain_bonds, with (34), sum j alpha_j = N^2/2: long waves have the speed 1. Points are
/// m pi/(N - 1), m = 1 .. N - 1, of as many parts of 0 .. pi; Galerkin's functions 1 - cos(j xi), j
/// = 1 .. N - 1. Exact where the equations are over Q[pi] or Q[pi, sqrt(d)]: always but for point
/// at N - 1 > 6 and subdomain at N - 1 = 5 and N - 1 > 6. Throws std::invalid_argument for another
/// N, and for bz_ls.
std::vector<BondCoefficient> chain_bonds(BondMethod method, unsigned horizon);

/// Of waves of 12.6 and 6.3 dX, whose phase velocities are listed [1/dX].
inline constexpr std::array listed_wave_numbers{0.5, 1.0};

/// |c/c_solid - 1| of a wave of xi.
double speed_error_of_chain(std::span<const double> alpha, double xi);

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
