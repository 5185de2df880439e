// SPDX-License-Identifier: MIT
/// The coefficients of the bonds of a square lattice: bond-based, nu = 1/4 in plane strain
/// (Alebrahim 2022, sections 3.2 and 5). Units: E = density = dX = 1.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "generator/bonds/chain_bonds.hpp"
#include "generator/table/exact.hpp"

namespace nmbcgen {

/// No coefficients at or above the bound have the speeds of long waves; what() says so.
struct BoundsNotMet : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// A class has all bonds (+-i, +-j) and (+-j, +-i), i >= j >= 0.
struct SquareBonds {
    std::vector<std::array<int, 2>> classes;  ///< shortest first
    std::vector<BondCoefficient> alpha;       ///< of the micromodulus 48/(5 pi N^3)
    std::vector<double> weights;              ///< of `bond2d`: 48 alpha/(5 pi N^3 r^3)
};

inline constexpr unsigned most_square_bonds = 5;

/// Those whose dynamical matrix D is nearest to the solid's: the least mean over the Brillouin zone
/// of the squared Frobenius norm of D - (V_S^2 k^2 I + (V_P^2 - V_S^2) k k^T), with the exact
/// speeds of long waves, V_P^2 = 6/5 and V_S^2 = 2/5, which has one solution. Family radius N dX, 2
/// <= N <= most_square_bonds. With a bound, the least mean of those alpha >= bound; that no other
/// is better is proved by its conditions of Karush, Kuhn and Tucker, to 100 digits. Throws
/// BoundsNotMet.
SquareBonds square_bonds(unsigned horizon, const std::optional<Rational>& bound);

/// A set of one's own, in the order of `classes`. Throws std::invalid_argument unless there is one
/// for each class.
SquareBonds given_square_bonds(unsigned horizon, const std::vector<Rational>& alpha);

/// The classes of bonds up to N dX, shortest first, and of equal ones that of larger i first.
std::vector<std::array<int, 2>> square_bond_classes(unsigned horizon);

/// What Alebrahim 2022 lists for its sets, of lattices whose waves do not grow.
struct SquareFigures {
    double residual = 0;              ///< (51)
    std::array<double, 2> speed_P{};  ///< of long waves at 0 and 45 degrees, over the solid's
    std::array<double, 2> speed_S{};
    double largest_frequency = 0;  ///< over the Brillouin zone
};

SquareFigures figures_of(const SquareBonds& bonds);

}  // namespace nmbcgen
