// SPDX-License-Identifier: MIT
/// The bonds of a square lattice, and what all methods know of them: bond-based, nu = 1/4 in plane
/// strain (Alebrahim 2022, sections 3.2 and 5). Units: E = density = dX = 1.
#pragma once

#include <array>
#include <stdexcept>
#include <vector>

#include "generator/bonds/chain_bonds.hpp"
#include "generator/exact/real.hpp"
#include "generator/table/exact.hpp"

namespace nmbcgen {

/// All bonds (+-i, +-j) and (+-j, +-i), i >= j >= 0.
using BondClass = std::array<int, 2>;

struct SquareBonds {
    std::vector<BondClass> classes;      ///< shortest first
    std::vector<BondCoefficient> alpha;  ///< of the micromodulus 48/(5 pi N^3)
    std::vector<double> weights;         ///< of `bond2d`: 48 alpha/(5 pi N^3 r^3)
};

/// There are no such coefficients; what() says why.
struct NoSuchBonds : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

inline constexpr unsigned most_square_bonds = 5;

/// The classes of bonds up to N dX, shortest first, and of equal ones that of larger i first.
std::vector<BondClass> square_bond_classes(unsigned horizon);

/// Each bond of the class, once.
std::vector<BondClass> members(const BondClass& bonds);

/// V_P^2 and V_S^2 of the solid.
inline const std::array<Rational, 2> squared_speeds{Rational(6, 5), Rational(2, 5)};

/// What a unit weight of the class adds to V_P^2 and V_S^2: (39) is linear in the weights.
std::array<Rational, 2> speeds_of_unit_weight(const BondClass& bonds);

/// The mean of k^2 cos(m k) on 0 .. pi, as the factors of 1 and pi^2.
std::array<Rational, 2> mean_of_square_times_cosine(int m);

Real alpha_of_unit_weight(unsigned horizon, const BondClass& bond);

/// The weight factors[0] + factors[1] pi^2 and its alpha, without a closed form where that is in
/// two quadratic fields.
Real weight_of(const std::array<Quadratic, 2>& factors);
BondCoefficient coefficient_of_weight(unsigned horizon, const BondClass& bond,
                                      const std::array<Quadratic, 2>& factors);

}  // namespace nmbcgen
