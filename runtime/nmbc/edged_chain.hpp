// SPDX-License-Identifier: MIT
/// The fastest motion of a chain between two edges, which limits the time step.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nmbc/edge_condition.hpp>
#include <nmbc/edge_damping.hpp>
#include <nmbc/edge_energy.hpp>
#include <nmbc/lattice.hpp>
#include <optional>
#include <vector>

namespace nmbc::detail {

/// Adds weight L^T (L u) of a stencil L, whose entries are at place(0), place(1), ..
template <class Place>
void add_force(double weight, const std::vector<double>& stencil, const Place& place,
               const std::vector<double>& u, std::vector<double>& force) {
    double sum = 0;
    for (std::size_t i = 0; i < stencil.size(); ++i) {
        sum += stencil[i] * u[place(i)];
    }
    for (std::size_t i = 0; i < stencil.size(); ++i) {
        force[place(i)] += weight * stencil[i] * sum;
    }
}

/// M^-1 K u of a chain between two edges.
inline std::vector<double> between_edges(const EdgeEnergy& edge, const Lattice& lattice,
                                         const std::vector<double>& u) {
    const std::size_t nodes = u.size();
    const std::size_t own = edge.mass.size();
    std::vector<double> force(nodes);
    for (const EdgeEnergy::Square& square : edge.squares) {
        add_force(
            square.weight, square.stencil, [](std::size_t i) { return i; }, u, force);
        add_force(
            square.weight, square.stencil, [=](std::size_t i) { return nodes - 1 - i; }, u, force);
    }
    for (const auto& [part, weight, stencil] : lattice.energy) {
        for (std::size_t node = own; node + own < nodes; ++node) {
            const std::size_t first = node - stencil.size() / 2;
            add_force(
                weight, stencil, [=](std::size_t i) { return first + i; }, u, force);
        }
    }
    for (std::size_t node = 0; node < own; ++node) {
        force[node] /= edge.mass[node];
        force[nodes - 1 - node] /= edge.mass[node];
    }
    return force;
}

/// Estimates -lambda of the fastest mode of a chain of this many nodes, by power iteration; of the
/// interior, if that is more. accelerate(u) puts the accelerations in the place of the
/// displacements u.
template <class Accelerate>
double fastest_mode(const Lattice& lattice, std::size_t nodes, const Accelerate& accelerate) {
    std::vector<double> u(nodes);
    for (std::size_t i = 0; i < nodes; ++i) {  // neither even nor odd about the middle
        const double size = 1 + static_cast<double>(i) / static_cast<double>(nodes);
        u[i] = i % 2 == 0 ? size : -size;
    }
    double largest = 0;
    constexpr int enough = 400;  // the error falls by the ratio of eigenvalues every time
    for (int iteration = 0; iteration < enough; ++iteration) {
        accelerate(u);
        largest = 0;
        for (const double entry : u) {
            largest = std::max(largest, std::abs(entry));
        }
        for (double& entry : u) {
            entry /= largest;
        }
    }
    const double top = maximum_frequency(lattice);
    return std::max(largest, top * top);
}

/// Whether Cholesky's decomposition of a symmetric matrix exists, of rows first .. last-1. entry(i,
/// j), j <= i; it is 0 for i - j >= width.
template <class Entry>
bool is_positive_definite(std::size_t first, std::size_t last, std::size_t width,
                          const Entry& entry) {
    std::vector<double> L(last * width);  // entry (i, i - k) at i * width + k
    for (std::size_t i = first; i < last; ++i) {
        double* const row = &L[i * width];
        const std::size_t band = std::min(i - first, width - 1);
        for (std::size_t k = band + 1; k-- > 0;) {
            const std::size_t j = i - k;
            double left = entry(i, j);
            for (std::size_t m = k + 1; m <= band; ++m) {
                left -= row[m] * L[j * width + m - k];
            }
            if (k > 0) {
                row[k] = left / L[j * width];
            } else if (left > 0) {
                row[0] = std::sqrt(left);
            } else {
                return false;
            }
        }
    }
    return true;
}

/// A chain between two edges.
struct EdgedChain {
    const EdgeEnergy& edge;
    const Lattice& lattice;
    const std::optional<EdgeDamping>& damping;
    bool is_held = false;  ///< u = 0 on the outermost nodes
    std::size_t nodes = 0;

    /// Estimates the largest eigenvalue of M^-1 K.
    double fastest() const {
        const auto hold = [this](std::vector<double>& field) {
            if (is_held) {
                field.front() = field.back() = 0;
            }
        };
        return fastest_mode(lattice, nodes, [&](std::vector<double>& u) {
            hold(u);
            u = between_edges(edge, lattice, u);
            hold(u);
        });
    }

    /// Whether leapfrog is stable in steps of 2/sqrt(bound), up to roundings. With the damping
    /// force C v of the old velocities it keeps no more than
    ///     v^T (M - dt C/2 - dt^2 K/4) v/2 + w^T K w/2,   w the mean of both displacements,
    /// which is an energy where Cholesky's decomposition of bound M - sqrt(bound) C - K exists:
    /// without damping, where all eigenvalues of M^-1 K are below the bound.
    bool is_stable_below(double bound) const;
};

inline bool EdgedChain::is_stable_below(double bound) const {
    const EdgeStiffness K = stiffness_of(edge, lattice);
    const EdgeStiffness C =
        damping ? stiffness_of(damping->edge, damping->lattice) : EdgeStiffness{};
    const double rate = std::sqrt(bound);
    const auto entry_of = [](const std::vector<double>& symbol, std::size_t distance) {
        return distance < symbol.size() ? symbol[distance] : 0;
    };
    const auto of_lattice = [&](std::size_t distance) {
        return entry_of(lattice.symbol, distance) +
               (damping ? rate * entry_of(damping->lattice.symbol, distance) : 0);
    };
    // What an edge puts in the place of the endless lattice.
    const auto change = [&](std::size_t row, std::size_t column) {
        const std::size_t distance = row > column ? row - column : column - row;
        return row < K.rows && column < K.columns
                   ? K.at(row, column) + (damping ? rate * C.at(row, column) : 0) -
                         of_lattice(distance)
                   : 0;
    };
    const auto mass = [&](std::size_t node) {
        const std::size_t depth = std::min(node, nodes - 1 - node);
        return depth < edge.mass.size() ? edge.mass[depth] : 1;
    };
    const std::size_t first = is_held ? 1 : 0;
    return is_positive_definite(first, nodes - first, K.columns, [&](std::size_t i, std::size_t j) {
        return (i == j ? bound * mass(i) : 0) - of_lattice(i - j) - change(i, j) -
               change(nodes - 1 - i, nodes - 1 - j);
    });
}

}  // namespace nmbc::detail
