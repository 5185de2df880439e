// SPDX-License-Identifier: MIT
#include "generator/plane/box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "generator/dense/decompositions.hpp"
#include "generator/plane/ghost_row.hpp"
#include "generator/plane/leapfrog.hpp"
#include "generator/plane/motion.hpp"

namespace nmbcgen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Rows are the two components of a node, nodes along x one after the other, ghosts among them.
class BoxRows {
  public:
    BoxRows(const PlaneLattice& lattice, const BoxSides& sides, Index nodes, double time_step)
        : lattice_(lattice),
          time_step_(time_step),
          reach_(reach_of(lattice)),
          all_(nodes + 2 * reach_) {
        for (const std::size_t axis : {0U, 1U}) {
            const SideCondition& condition = axis == 0 ? sides.across_x : sides.across_y;
            for (const std::size_t a : {0U, 1U}) {
                residuals_[axis][a] = at_midpoints(condition.residual[a], time_step);
            }
        }
    }

    Motion motion() const {
        MotionRows rows{
            .orders = {},
            .is_damped = std::ranges::any_of(
                lattice_.bonds, [](const PlaneBond& bond) { return !bond.damping.isZero(0); }),
            .time_step = time_step_};
        for (Index row = 0; row < 2 * all_ * all_; ++row) {
            const auto [i, j] = node_of(row);
            rows.orders.push_back(!is_inside(i) ? order_of(0) : !is_inside(j) ? order_of(1) : 0);
        }
        return {rows, [this](MotionFields& fields) { accelerate(fields); },
                [this](int order, const std::vector<const MatrixXd*>& lower, MatrixXd& highest) {
                    for (const Index axis : {1, 0}) {
                        for (const Index inwards : {1, -1}) {
                            if (order_of(axis) == order) {
                                close_side(axis, inwards, highest, lower);
                            }
                        }
                    }
                }};
    }

    /// Motions are even or odd in x, 1 or -1, and in y: the quarter of low i and j tells them.
    Motion::Image mirror(Index row, int in_x, int in_y) const {
        auto [i, j] = node_of(row);
        const Index a = row % 2;
        double sign = 1;
        if (2 * i >= all_) {
            i = all_ - 1 - i;
            sign *= a == 0 ? -in_x : in_x;
        }
        if (2 * j >= all_) {
            j = all_ - 1 - j;
            sign *= a == 1 ? -in_y : in_y;
        }
        return {.row = row_of(i, j, a), .sign = sign};
    }

  private:
    static Index reach_of(const PlaneLattice& lattice) {
        int reach = 0;
        for (const PlaneBond& bond : lattice.bonds) {
            reach = std::max({reach, std::abs(bond.offset[0]), std::abs(bond.offset[1])});
        }
        return reach;
    }

    Index row_of(Index i, Index j, Index component) const { return 2 * (j * all_ + i) + component; }
    std::array<Index, 2> node_of(Index row) const { return {row / 2 % all_, row / 2 / all_}; }
    bool is_inside(Index at) const { return at >= reach_ && at < all_ - reach_; }
    int order_of(Index axis) const { return int(residuals_[std::size_t(axis)][0].size()) - 1; }

    void accelerate(MotionFields& fields) const {
        for (Index j = reach_; j < all_ - reach_; ++j) {
            for (Index i = reach_; i < all_ - reach_; ++i) {
                for (const Index a : {0, 1}) {
                    accelerate(fields, i, j, a);
                }
            }
        }
    }

    void accelerate(MotionFields& fields, Index i, Index j, Index a) const {
        auto own = fields.acceleration.row(row_of(i, j, a));
        for (const PlaneBond& bond : lattice_.bonds) {
            for (const Index b : {0, 1}) {
                const Index from = row_of(i + bond.offset[0], j + bond.offset[1], b);
                own -= bond.stiffness(a, b) * fields.displacement.row(from) +
                       bond.damping(a, b) * fields.velocity.row(from);
            }
        }
    }

    /// The rows of ghosts of the highest derivative from those of the lower ones, outwards.
    void close_side(Index axis, Index inwards, MatrixXd& highest,
                    const std::vector<const MatrixXd*>& lower) const {
        const Index corner = axis == 0 ? 0 : reach_;
        for (Index ghost = reach_ - 1; ghost >= 0; --ghost) {
            const Index layer = inwards == 1 ? ghost : all_ - 1 - ghost;
            for (Index along = corner; along < all_ - corner; ++along) {
                for (const Index a : {0, 1}) {
                    close_ghost(residuals_[std::size_t(axis)][a == axis ? 0 : 1], lower, highest,
                                [&](std::size_t shift) {
                                    const Index at = layer + inwards * Index(shift);
                                    return axis == 0 ? row_of(at, along, a) : row_of(along, at, a);
                                });
                }
            }
        }
    }

    const PlaneLattice& lattice_;
    double time_step_;
    Index reach_;
    Index all_;  ///< nodes along an axis, with ghosts
    /// Of the sides across x, and across y.
    std::array<std::array<ShiftPolynomial, 2>, 2> residuals_;
};

}  // namespace

double growth_in_box(const PlaneLattice& lattice, const BoxSides& sides, std::size_t nodes,
                     double time_step) {
    const BoxRows rows(lattice, sides, Index(nodes), time_step);
    const Motion motion = rows.motion();
    double largest = -HUGE_VAL;
    for (const int in_x : {1, -1}) {
        for (const int in_y : {1, -1}) {
            const MatrixXd quarter =
                motion.map([&](Index row) { return rows.mirror(row, in_x, in_y); });
            largest = std::max(largest, largest_growth(eigenvalues(quarter), time_step));
        }
    }
    return largest;
}

}  // namespace nmbcgen
