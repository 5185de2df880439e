// SPDX-License-Identifier: MIT
/// The potential energies of a plane lattice between its sides.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <nmbc/plane_nodes.hpp>

namespace nmbc::detail {

/// Potential energies: of a displacement, quadratic in it.
struct PlanePotential {
    double strain = 0;  ///< without the null Lagrangian
    double null_lagrangian = 0;
    double stabilisation = 0;

    double total() const { return strain + null_lagrangian + stabilisation; }
    void add(const PlanePotential& other) {
        strain += other.strain;
        null_lagrangian += other.null_lagrangian;
        stabilisation += other.stabilisation;
    }
};

inline constexpr std::ptrdiff_t energy_block = 64;  ///< nodes whose sums run side by side

/// W, what beta adds to it, from the gradient.
inline PlanePotential potential_of_gradient(const CorrespondenceModel& model,
                                            const std::array<double, 4>& g) {
    const double k = model.bulk;
    const double mu = model.shear;
    const double trace = g[0] + g[3];
    const double shear = g[1] + g[2];
    return {
        .strain = (k * trace * trace + mu * ((g[0] - g[3]) * (g[0] - g[3]) + shear * shear)) / 2,
        .null_lagrangian = model.null_lagrangian * (g[0] * g[3] - g[1] * g[2])};
}

/// Of one node.
template <class Real>
PlanePotential potential_of_node(const PlaneNodes& nodes, std::ptrdiff_t x, std::ptrdiff_t y,
                                 const std::array<Real*, 2>& u) {
    const PlaneNeighbours& near = nodes.neighbours(x, y);
    const std::ptrdiff_t at = y * nodes.pitch() + x;
    const ClosedNode* const closed = nodes.closed(x, y);
    const auto g =
        closed != nullptr ? PlaneNodes::gradient(*closed, at, u) : nodes.gradient(near, at, u);
    double squares = 0;
    for (const auto& bond : near.bonds) {
        for (std::size_t a = 0; a < 2; ++a) {
            const double z = static_cast<double>(u[a][at + bond.entry]) -
                             static_cast<double>(u[a][at]) - g[2 * a] * bond.x -
                             g[2 * a + 1] * bond.y;
            squares += bond.influence * z * z;
        }
    }
    const PlaneWeights own = nodes.weights(x, y);
    PlanePotential energy = potential_of_gradient(nodes.model(), g);
    energy.strain *= own.strain;
    energy.null_lagrangian *= own.strain;
    energy.stabilisation = own.stabilisation * nodes.model().stabilisation / 2 * squares;
    return energy;
}

/// Of `count` nodes with whole families, side by side.
template <class Real>
PlanePotential potential_of_block(const PlaneNodes& nodes, std::ptrdiff_t y, std::ptrdiff_t x,
                                  std::ptrdiff_t count, const std::array<Real*, 2>& u) {
    const PlaneNeighbours& near = nodes.neighbours(x, y);
    const std::ptrdiff_t at = y * nodes.pitch() + x;
    using Block = std::array<double, static_cast<std::size_t>(energy_block)>;
    std::array<Block, 4> g{};
    Block squares{};
    const auto size = static_cast<std::size_t>(count);
    for (std::size_t a = 0; a < 2; ++a) {
        Block& by_x = g[2 * a];
        Block& by_y = g[2 * a + 1];
        for (const auto& bond : near.bonds) {
            const double dx = bond.influence * bond.x * near.inverse_shape[0];
            const double dy = bond.influence * bond.y * near.inverse_shape[2];
            const Real* const there = u[a] + at + bond.entry;
            for (std::size_t i = 0; i < size; ++i) {
                by_x[i] += dx * static_cast<double>(there[i]);
                by_y[i] += dy * static_cast<double>(there[i]);
            }
        }
        const Real* const own = u[a] + at;
        for (const auto& bond : near.bonds) {
            const Real* const there = u[a] + at + bond.entry;
            for (std::size_t i = 0; i < size; ++i) {
                const double z = static_cast<double>(there[i]) - static_cast<double>(own[i]) -
                                 by_x[i] * bond.x - by_y[i] * bond.y;
                squares[i] += bond.influence * z * z;
            }
        }
    }
    PlanePotential sum;
    for (std::size_t i = 0; i < size; ++i) {
        sum.add(potential_of_gradient(nodes.model(), {g[0][i], g[1][i], g[2][i], g[3][i]}));
        sum.stabilisation += nodes.model().stabilisation / 2 * squares[i];
    }
    return sum;
}

/// Of the nodes first .. last-1 of a row.
template <class Real>
PlanePotential potential_of_row(const PlaneNodes& nodes, std::ptrdiff_t y, std::ptrdiff_t first,
                                std::ptrdiff_t last, const std::array<Real*, 2>& u) {
    PlanePotential sum;
    const PlaneAxis::Range xs = nodes.x().plain_stress();
    const PlaneAxis::Range ys = nodes.y().plain_stress();
    const bool is_plain = y >= ys.first && y < ys.last;
    for (std::ptrdiff_t x = first; x < last;) {
        if (is_plain && x >= xs.first && x < xs.last) {
            const std::ptrdiff_t end = std::min({last, xs.last, x + energy_block});
            sum.add(potential_of_block(nodes, y, x, end - x, u));
            x = end;
        } else {
            sum.add(potential_of_node(nodes, x, y, u));
            ++x;
        }
    }
    return sum;
}

}  // namespace nmbc::detail
