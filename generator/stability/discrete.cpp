// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/stability/discrete.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <stdexcept>

#include "generator/stability/modal.hpp"

namespace nmbcgen {

Eigen::MatrixXd one_step_map(const HalfSpace& h, std::size_t nodes, double time_step,
                             GhostLevel level) {
    const auto ghosts = Eigen::Index(h.reach());
    const auto interior = Eigen::Index(nodes);
    const Eigen::Index all = interior + 2 * ghosts;
    const Eigen::Index order = Eigen::Index(h.c.size()) - 1;
    if (interior < order * h.stride) {
        throw std::invalid_argument("the chain is shorter than the condition reaches");
    }

    // Rows of `velocity`: v at k+1/2 on all nodes as a linear function of the state.
    Eigen::MatrixXd velocity = Eigen::MatrixXd::Zero(all, all + interior);
    for (Eigen::Index i = 0; i < interior; ++i) {
        auto row = velocity.row(ghosts + i);
        row(all + i) = 1;
        row(ghosts + i) = -time_step * h.symbol[0];
        for (Eigen::Index m = 1; m <= ghosts; ++m) {
            row(ghosts + i + m) -= time_step * h.symbol[std::size_t(m)];
            row(ghosts + i - m) -= time_step * h.symbol[std::size_t(m)];
        }
    }
    const double implicit_time = level == GhostLevel::midpoint ? time_step / 2 : 0;
    for (Eigen::Index layer = ghosts; layer-- > 0;) {
        for (const bool left : {true, false}) {
            const Eigen::Index ghost = left ? layer : all - 1 - layer;
            const Eigen::Index inwards = left ? h.stride : -h.stride;
            Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(all + interior);
            for (Eigen::Index j = 0; j <= order; ++j) {
                const Eigen::Index node = ghost + j * inwards;
                const double b = h.b[std::size_t(j)];
                row(node) += b;
                if (j > 0) {
                    row += (implicit_time * b - h.c[std::size_t(j)]) * velocity.row(node);
                }
            }
            velocity.row(ghost) = row / (h.c[0] - implicit_time * h.b[0]);
        }
    }
    Eigen::MatrixXd map = Eigen::MatrixXd::Identity(all + interior, all + interior);
    map.topRows(all) += time_step * velocity;
    map.bottomRows(interior) = velocity.middleRows(ghosts, interior);
    return map;
}

double spectral_radius(const HalfSpace& half_space, std::size_t nodes, double time_step,
                       GhostLevel level) {
    return one_step_map(half_space, nodes, time_step, level).eigenvalues().cwiseAbs().maxCoeff();
}

double maximum_frequency(const HalfSpace& half_space) {
    return critical_frequencies(half_space).back();
}

namespace {

bool is_stable(const HalfSpace& half_space, KnownModes& modes, GhostLevel level, double time_step) {
    if (level == GhostLevel::midpoint) {
        return stability_grade(stepped(half_space, time_step), modes) != Grade::none;
    }
    // The double eigenvalue 1 of a constant and of a uniform velocity splits by roundings only.
    constexpr double stable = 1 + 1e-9;
    const std::size_t shortest = (half_space.c.size() - 1) * std::size_t(half_space.stride);
    return spectral_radius(half_space, shortest + 11, time_step, level) <= stable &&
           spectral_radius(half_space, shortest + 20, time_step, level) <= stable;
}

}  // namespace

double largest_cfl(const HalfSpace& half_space, GhostLevel level) {
    const double top = maximum_frequency(half_space);
    KnownModes modes(half_space);
    const auto stable_at = [&](int hundredths) {
        return is_stable(half_space, modes, level, 2 * hundredths / (100 * top));
    };
    constexpr int coarse = 5;
    int largest = 0;
    while (largest + coarse < 100 && stable_at(largest + coarse)) {
        largest += coarse;
    }
    while (largest + 1 < 100 && stable_at(largest + 1)) {
        ++largest;
    }
    return largest / 100.0;
}

}  // namespace nmbcgen
