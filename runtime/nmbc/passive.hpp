// SPDX-License-Identifier: MIT
/// Ends of chains that are stable by construction: the chain is cut off there, with springs, masses
/// and dashpots of its own on the outermost nodes, so that waves leave. Sides of planes:
/// plane_sides.hpp has their numbers, plane_dashpots.hpp what these do in a step.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/certificate.hpp>
#include <nmbc/lattice.hpp>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace nmbc {

/// The end of a chain, counted inwards from its outermost node, where the lattice has E = rho = dX
/// = 1: on `rows` nodes the equation of motion is
///     M u'' = -K u - C u',
/// M diagonal and 1 but for the outermost nodes, C of these alone; on all others it is the
/// lattice's. While K and C are sums of squares and M is positive, no step raises
///     v.M v/2 + u(t+dt).K u(t)/2   of the whole chain, v at t + dt/2,
/// which has a least value in steps with dt^2 times the highest eigenvalue of M^-1 K below 4
/// (midpoint dashpots). `nmbcgen passive` designs such ends.
struct PassiveEnd {
    std::size_t rows = 0;           ///< outermost nodes, with forces of their own
    std::vector<double> stiffness;  ///< K: rows times (rows + reach of the lattice), row by row
    std::vector<double> mass;       ///< the diagonal of M, of the q outermost nodes, q <= rows
    std::vector<double> dashpots;   ///< C: q times q, row by row
    double highest_eigenvalue = 0;  ///< of M^-1 K, in the interior as well
    /// Nodes of the lattice between these and the interior, on which what decays beside the end
    /// does so. The end adds both to the chain.
    std::size_t further = 0;

    /// Throws std::invalid_argument for sizes that do not fit, numbers that are not finite or
    /// positive, and a damped lattice; NotCertified for another lattice than it was made for, and
    /// for steps that are too long.
    template <class Real>
    std::unique_ptr<BoundaryCondition<Real>> make(const Lattice& lattice, const ChainParameters& p,
                                                  std::type_identity<Real> precision) const;
};

namespace detail {

/// The inverse of a matrix that is symmetric and positive definite, row by row.
inline std::vector<double> inverse_of(std::vector<double> matrix, std::size_t size) {
    std::vector<double> inverse(size * size);
    for (std::size_t i = 0; i < size; ++i) {
        inverse[i * size + i] = 1;
    }
    for (std::size_t pivot = 0; pivot < size; ++pivot) {  // Gauss and Jordan
        const double scale = 1 / matrix[pivot * size + pivot];
        for (std::size_t column = 0; column < size; ++column) {
            matrix[pivot * size + column] *= scale;
            inverse[pivot * size + column] *= scale;
        }
        for (std::size_t row = 0; row < size; ++row) {
            const double factor = row == pivot ? 0 : matrix[row * size + pivot];
            for (std::size_t column = 0; column < size; ++column) {
                matrix[row * size + column] -= factor * matrix[pivot * size + column];
                inverse[row * size + column] -= factor * inverse[pivot * size + column];
            }
        }
    }
    return inverse;
}

/// A matrix, row by row, with the first rows multiplied by a square one, and the others as they
/// are.
inline std::vector<double> product(const std::vector<double>& square, std::size_t size,
                                   const std::vector<double>& matrix, std::size_t columns) {
    std::vector<double> result = matrix;
    for (std::size_t i = 0; i < size * columns; ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < size; ++k) {
            sum += square[i / columns * size + k] * matrix[k * columns + i % columns];
        }
        result[i] = sum;
    }
    return result;
}

/// In a step v+ = S ((M - dt C/2) v- - dt K u) with S the inverse of M + dt C/2. The lattice's own
/// force K' has made v- into v* = v- - dt K' u, so that
///     v+ = A v* + B u,   A = S (M - dt C/2),   B = dt (A K' - S K).
template <class Real>
class PassiveCondition final : public BoundaryCondition<Real> {
  public:
    PassiveCondition(const PassiveEnd& end, const Lattice& lattice, const ChainParameters& p)
        : ghosts_(lattice.reach()),
          rows_(end.rows),
          further_(end.further),
          columns_(end.rows + ghosts_),
          moved_(end.mass.size()),
          velocities_(padded(moved_) * moved_),
          displacements_(padded(rows_) * columns_),
          new_(padded(rows_)),
          forces_(rows_ * columns_),
          drags_(moved_ * moved_) {
        const double rate = p.wave_speed() / p.spacing;
        const double step = p.time_step * rate;
        std::vector<double> sum(moved_ * moved_);
        std::vector<double> difference(moved_ * moved_);
        for (std::size_t i = 0; i < moved_ * moved_; ++i) {
            const double mass = i / moved_ == i % moved_ ? end.mass[i / moved_] : 0;
            sum[i] = mass + step / 2 * end.dashpots[i];
            difference[i] = mass - step / 2 * end.dashpots[i];
        }
        const std::vector<double> solve = inverse_of(std::move(sum), moved_);         // S
        const std::vector<double> kept = product(solve, moved_, difference, moved_);  // A
        for (std::size_t i = 0; i < moved_ * moved_; ++i) {
            velocities_[place(i / moved_, i % moved_, moved_)] = static_cast<Real>(kept[i]);
        }
        // A K' - S K, where A and S are those of the outermost nodes and 1 elsewhere.
        std::vector<double> of_lattice(rows_ * columns_);
        for (std::size_t i = 0; i < of_lattice.size(); ++i) {
            const std::size_t row = i / columns_;
            const std::size_t column = i % columns_;
            const std::size_t distance = std::max(row, column) - std::min(row, column);
            of_lattice[i] = distance < lattice.symbol.size() ? lattice.symbol[distance] : 0;
        }
        const std::vector<double> lost = product(kept, moved_, of_lattice, columns_);
        const std::vector<double> gained = product(solve, moved_, end.stiffness, columns_);
        for (std::size_t i = 0; i < of_lattice.size(); ++i) {
            displacements_[place(i / columns_, i % columns_, columns_)] =
                static_cast<Real>(step * rate * (lost[i] - gained[i]));
            const std::size_t row = i / columns_;
            const double mass = row < moved_ ? end.mass[row] : 1;
            forces_[i] = rate * rate * (of_lattice[i] - end.stiffness[i] / mass);
        }
        for (std::size_t i = 0; i < moved_ * moved_; ++i) {
            drags_[i] = -rate * end.dashpots[i] / end.mass[i / moved_];
        }
    }

    std::size_t layer_nodes() const override { return rows_ + further_; }
    std::size_t least_interior_nodes() const override {
        return std::max<std::size_t>(ghosts_, further_ + 1) - further_;
    }

    /// Beyond the outermost node there is nothing: what stands there is 0 and acts on nothing.
    void start(NodeLine<Real> u, NodeLine<Real> v, std::size_t /*step*/) override {
        for (std::size_t ghost = 0; ghost < ghosts_; ++ghost) {
            u[ghost] = 0;
            v[ghost] = 0;
        }
    }

    void after_start(NodeLine<const Real> u, NodeLine<Real> v, double duration) override {
        const auto add = [&](const std::vector<double>& matrix, std::size_t rows,
                             std::size_t columns, NodeLine<const Real> field) {
            std::vector<double> change(rows);
            for (std::size_t i = 0; i < matrix.size(); ++i) {
                change[i / columns] +=
                    matrix[i] * static_cast<double>(field[ghosts_ + i % columns]);
            }
            for (std::size_t row = 0; row < rows; ++row) {
                v[ghosts_ + row] += static_cast<Real>(duration * change[row]);
            }
        };
        add(forces_, rows_, columns_, u);
        add(drags_, moved_, moved_, v);
    }

    void after_kick(NodeLine<const Real> u, NodeLine<Real> v, std::size_t /*step*/) override {
        for (std::size_t block = 0; block < new_.size(); block += lanes) {
            Sums sums{};
            for (std::size_t row = std::max(block, moved_); row < std::min(block + lanes, rows_);
                 ++row) {
                sums[row - block] = v[ghosts_ + row];
            }
            if (block < moved_) {
                add(sums, velocities_, block, moved_, v);
            }
            add(sums, displacements_, block, columns_, u);
            std::ranges::copy(sums, new_.begin() + static_cast<std::ptrdiff_t>(block));
        }
        for (std::size_t row = 0; row < rows_; ++row) {
            v[ghosts_ + row] = new_[row];
        }
        for (std::size_t ghost = 0; ghost < ghosts_; ++ghost) {
            v[ghost] = 0;
        }
    }

  private:
    static constexpr std::size_t lanes = 4;  ///< rows whose sums do not wait for each other
    using Sums = std::array<Real, lanes>;

    static std::size_t padded(std::size_t rows) { return (rows + lanes - 1) / lanes * lanes; }

    /// Where the entry of a matrix with so many columns lies.
    static std::size_t place(std::size_t row, std::size_t column, std::size_t columns) {
        return (row / lanes * columns + column) * lanes + row % lanes;
    }

    /// The block's rows of a matrix, times what the field has on the chain's own nodes.
    void add(Sums& sums, const std::vector<Real>& matrix, std::size_t block, std::size_t columns,
             NodeLine<const Real> field) const {
        const Real* const entries = matrix.data() + block * columns;
        for (std::size_t column = 0; column < columns; ++column) {
            const Real value = field[ghosts_ + column];
            for (std::size_t row = 0; row < lanes; ++row) {
                sums[row] += entries[column * lanes + row] * value;
            }
        }
    }

    std::size_t ghosts_;
    std::size_t rows_;
    std::size_t further_;
    std::size_t columns_;
    std::size_t moved_;                ///< nodes with a mass and dashpots of their own
    std::vector<Real> velocities_;     // A, in blocks of rows, column by column
    std::vector<Real> displacements_;  // B, likewise
    std::vector<Real> new_;            // v of the rows
    std::vector<double> forces_;       // K' - M^-1 K, of the start, row by row
    std::vector<double> drags_;        // -M^-1 C, likewise
};

}  // namespace detail

template <class Real>
std::unique_ptr<BoundaryCondition<Real>> PassiveEnd::make(
    const Lattice& lattice, const ChainParameters& p,
    std::type_identity<Real> /*precision*/) const {
    if (mass.empty() || mass.size() > rows || dashpots.size() != mass.size() * mass.size() ||
        stiffness.size() != rows * (rows + lattice.reach())) {
        throw std::invalid_argument(
            "a passive end of q masses and m rows, q = 1 .. m, needs q * q dashpots and m * (m + " +
            std::to_string(lattice.reach()) + ") entries of the stiffness");
    }
    if (!std::ranges::all_of(mass, [](double one) { return one > 0 && std::isfinite(one); }) ||
        !(highest_eigenvalue > 0)) {
        throw std::invalid_argument(
            "the masses and the highest eigenvalue of a passive end must be positive");
    }
    const auto is_finite = [](double one) { return std::isfinite(one); };
    if (!std::ranges::all_of(stiffness, is_finite) || !std::ranges::all_of(dashpots, is_finite)) {
        throw std::invalid_argument("the matrices of a passive end must be finite");
    }
    if (!lattice.damping.empty()) {
        throw std::invalid_argument("a passive end needs a lattice without damping");
    }
    // The row next to the interior has its forces towards it.
    const std::size_t columns = rows + lattice.reach();
    for (std::size_t m = 1; m <= lattice.reach(); ++m) {
        const double own = stiffness[(rows - 1) * columns + rows - 1 + m];
        const double of_lattice = m < lattice.symbol.size() ? lattice.symbol[m] : 0;
        constexpr double roundings = 1e-9;
        if (!(std::abs(own - of_lattice) <= roundings * lattice.symbol[0])) {
            throw NotCertified(
                "this passive end was made for another lattice: horizon, G or family are not those "
                "of the chain");
        }
    }
    const double longest = 2 / std::sqrt(highest_eigenvalue);
    const double step = p.time_step * p.wave_speed() / p.spacing;
    if (!(step > 0)) {
        throw std::invalid_argument("a passive end needs a positive time step, speed and spacing");
    }
    if (!(step < longest)) {
        throw NotCertified("a chain with this passive end is stable in steps below " +
                           std::to_string(longest) + " dX/c, and the step is " +
                           std::to_string(step) + " dX/c");
    }
    return std::make_unique<detail::PassiveCondition<Real>>(*this, lattice, p);
}

}  // namespace nmbc
