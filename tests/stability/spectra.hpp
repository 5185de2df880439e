// SPDX-License-Identifier: GPL-2.0-or-later
/// Spectra of assembled chains with two like ends.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <vector>

#include "generator/dense/decompositions.hpp"
#include "generator/stability/half_space.hpp"

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

/// All eigenvalues of such a matrix or of a one-step map: on u on `all` nodes, then v on the
/// interior ones or on all, each in the order of the nodes. Even states and odd
/// ones apart: that takes a quarter of the time, and where modes come in even and odd pairs it
/// keeps roundings from splitting them.
inline std::vector<std::complex<double>> eigenvalues_by_parity(const Eigen::MatrixXd& matrix,
                                                               Eigen::Index all) {
    const auto mirror = [&](Eigen::Index i) {
        return i < all ? all - 1 - i : matrix.rows() + all - 1 - i;
    };
    std::vector<std::complex<double>> eigenvalues;
    for (const double sign : {1.0, -1.0}) {
        std::vector<Eigen::Index> kept;
        for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
            if (i < mirror(i) || (i == mirror(i) && sign > 0)) {
                kept.push_back(i);
            }
        }
        Eigen::MatrixXd half = matrix(kept, kept);
        for (std::size_t j = 0; j < kept.size(); ++j) {
            if (mirror(kept[j]) != kept[j]) {
                half.col(Eigen::Index(j)) += sign * matrix(kept, mirror(kept[j]));
            }
        }
        const Eigen::VectorXcd found = nmbcgen::eigenvalues(half);
        eigenvalues.insert(eigenvalues.end(), found.begin(), found.end());
    }
    return eigenvalues;
}

/// The largest Re s [c/dX] of the chain in continuous time.
inline double spectral_abscissa(const HalfSpace& half_space, std::size_t nodes) {
    double largest = -HUGE_VAL;
    const auto all = Eigen::Index(nodes + 2 * half_space.reach());
    for (const auto s : eigenvalues_by_parity(semi_discrete_chain(half_space, nodes), all)) {
        largest = std::max(largest, s.real());
    }
    return largest;
}

}  // namespace nmbcgen::test
