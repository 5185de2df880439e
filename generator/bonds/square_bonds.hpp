// SPDX-License-Identifier: MIT
/// The least squares of the dynamical matrix of a square lattice, and what a set of coefficients
/// does. Units: E = density = dX = 1.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "generator/bonds/square_lattice.hpp"
#include "generator/table/exact.hpp"

namespace nmbcgen {

/// Those whose dynamical matrix D is nearest to the solid's: the least mean over the Brillouin zone
/// of the squared Frobenius norm of D - (V_S^2 k^2 I + (V_P^2 - V_S^2) k k^T), with the exact
/// speeds of long waves, V_P^2 = 6/5 and V_S^2 = 2/5, which has one solution. Family radius N dX, 2
/// <= N <= most_square_bonds. With a bound, the least mean of those alpha >= bound; that no other
/// is better is proved by its conditions of Karush, Kuhn and Tucker, to 100 digits. Throws
/// NoSuchBonds where no coefficients at or above the bound have these speeds.
SquareBonds square_bonds(unsigned horizon, const std::optional<Rational>& bound);

/// A set of one's own, in the order of `classes`. Throws std::invalid_argument unless there is one
/// for each class.
SquareBonds given_square_bonds(unsigned horizon, const std::vector<Rational>& alpha);

/// What Alebrahim 2022 lists for its sets, of lattices whose waves do not grow.
struct SquareFigures {
    double residual = 0;              ///< (51)
    std::array<double, 2> speed_P{};  ///< of long waves at 0 and 45 degrees, over the solid's
    std::array<double, 2> speed_S{};
    double largest_frequency = 0;  ///< over the Brillouin zone
    /// The largest |c/c_solid - 1| of P and S waves at any angle, at each of listed_wave_numbers.
    std::array<std::array<double, 2>, 2> speed_error{};
};

SquareFigures figures_of(const SquareBonds& bonds);

}  // namespace nmbcgen
