// SPDX-License-Identifier: GPL-2.0-or-later
/// Spectra of assembled chains with two like ends.
#pragma once

#include <Eigen/Core>
#include <cstdlib>

#include "generator/stability/discrete.hpp"

namespace nmbcgen::test {

/// d/dt of (u on all nodes, v on the interior nodes) in continuous time: u' = v, with the ghosts'
/// by (60), and v' = -symbol u - damping v.
inline Eigen::MatrixXd semi_discrete_chain(const HalfSpace& h, std::size_t nodes) {
    const auto ghosts = Eigen::Index(h.reach());
    const auto interior = Eigen::Index(nodes);
    const Eigen::Index all = interior + 2 * ghosts;
    Eigen::MatrixXd rate = Eigen::MatrixXd::Zero(all + interior, all + interior);
    rate.block(ghosts, all, interior, interior).setIdentity();
    for (Eigen::Index layer = ghosts; layer-- > 0;) {
        for (const Eigen::Index inwards : {1, -1}) {
            const Eigen::Index ghost = inwards > 0 ? layer : all - 1 - layer;
            for (std::size_t j = 0; j < h.c.size(); ++j) {
                const Eigen::Index node = ghost + inwards * Eigen::Index(j) * h.stride;
                rate(ghost, node) += h.b[j] / h.c[0];
                if (j > 0) {
                    rate.row(ghost) -= h.c[j] / h.c[0] * rate.row(node);
                }
            }
        }
    }
    for (Eigen::Index i = 0; i < interior; ++i) {
        for (Eigen::Index m = -ghosts; m <= ghosts; ++m) {
            const auto distance = std::size_t(std::abs(m));
            rate(all + i, ghosts + i + m) -= h.symbol[distance];
            if (h.is_damped()) {
                rate.row(all + i) -= h.damping[distance] * rate.row(ghosts + i + m);
            }
        }
    }
    return rate;
}

/// The largest Re s [c/dX] of the chain in continuous time.
inline double spectral_abscissa(const HalfSpace& half_space, std::size_t nodes) {
    const auto all = Eigen::Index(nodes + 2 * half_space.reach());
    return eigenvalues_by_parity(semi_discrete_chain(half_space, nodes), all).real().maxCoeff();
}

}  // namespace nmbcgen::test
