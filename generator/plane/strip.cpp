// SPDX-License-Identifier: MIT
#include "generator/plane/strip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "generator/dense/decompositions.hpp"
#include "generator/plane/ghost_row.hpp"
#include "generator/plane/leapfrog.hpp"
#include "generator/plane/motion.hpp"

namespace nmbcgen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Rows are components of layers from left to right, ghosts of sides with a condition among them.
class StripRows {
  public:
    StripRows(const LateralChain& chain, const Strip& strip)
        : chain_(chain),
          strip_(strip),
          size_(chain.components()),
          sides_{&strip.left, &strip.right},
          ghosts_{ghosts_of(strip.left), ghosts_of(strip.right)},
          all_(Index(strip.layers) + ghosts_[0] + ghosts_[1]) {
        for (const std::size_t side : {0U, 1U}) {
            if (const auto* const condition = std::get_if<SideCondition>(sides_[side])) {
                for (const std::size_t a : {0U, 1U}) {
                    residuals_[side][a] = at_midpoints(condition->residual[a], strip.time_step);
                }
            }
        }
    }

    Motion motion() const {
        MotionRows rows{.orders = std::vector<int>(std::size_t(size_ * all_)),
                        .is_damped = std::ranges::any_of(
                            chain_.damping, [](const MatrixXd& entry) { return !entry.isZero(0); }),
                        .time_step = strip_.time_step};
        for (const std::size_t side : {0U, 1U}) {
            for (Index ghost = 0; ghost < ghosts_[side]; ++ghost) {
                for (Index a = 0; a < size_; ++a) {
                    rows.orders[std::size_t(row_of(side, ghost, a))] = order_of(side);
                }
            }
        }
        return {rows, [this](MotionFields& fields) { accelerate(fields); },
                [this](int order, const std::vector<const MatrixXd*>& lower, MatrixXd& highest) {
                    close(order, lower, highest);
                }};
    }

    /// Like sides: motions are even or odd in x, parity 1 or -1.
    Motion::Image mirror(Index row, int parity) const {
        const Index layer = row / size_;
        const Index a = row % size_;
        const int sign = a == 0 ? -parity : parity;
        const Index mirrored = all_ - 1 - layer;
        if (layer == mirrored) {
            return {.row = row, .sign = sign == 1 ? 1.0 : 0.0};
        }
        return layer < mirrored ? Motion::Image{row, 1}
                                : Motion::Image{size_ * mirrored + a, double(sign)};
    }

  private:
    Index ghosts_of(const StripSide& side) const {
        return std::holds_alternative<SideCondition>(side) ? Index(chain_.reach()) : 0;
    }

    int order_of(std::size_t side) const { return int(residuals_[side][0].size()) - 1; }

    /// The layer so many inwards from a side's outermost one.
    Index row_of(std::size_t side, Index inwards, Index a) const {
        return size_ * (side == 0 ? inwards : all_ - 1 - inwards) + a;
    }

    void accelerate(MotionFields& fields) const {
        const auto reach = Index(chain_.reach());
        const auto rows = [&](MatrixXd& matrix, Index layer) {
            return matrix.middleRows(size_ * layer, size_);
        };
        for (Index layer = ghosts_[0]; layer < all_ - ghosts_[1]; ++layer) {
            for (Index r = -reach; r <= reach; ++r) {
                const auto from = std::size_t(r + reach);
                if (layer + r >= 0 && layer + r < all_) {
                    rows(fields.acceleration, layer) -=
                        chain_.stiffness[from] * rows(fields.displacement, layer + r) +
                        chain_.damping[from] * rows(fields.velocity, layer + r);
                }
            }
        }
        for (const std::size_t side : {0U, 1U}) {
            if (const auto* const cut = std::get_if<CutSide>(sides_[side])) {
                accelerate_beside(side, cut->stiffness, fields);
            }
        }
    }

    /// A right side is the mirror image of a left one.
    void accelerate_beside(std::size_t side, const MatrixXd& stiffness,
                           MotionFields& fields) const {
        const auto sign = [&](Index a) { return side == 1 && a == 0 ? -1.0 : 1.0; };
        for (Index i = 0; i < stiffness.rows(); ++i) {
            auto own = fields.acceleration.row(row_of(side, i / size_, i % size_));
            own.setZero();
            for (Index j = 0; j < stiffness.cols(); ++j) {
                own -= sign(i % size_) * sign(j % size_) * stiffness(i, j) *
                       fields.displacement.row(row_of(side, j / size_, j % size_));
            }
        }
    }

    /// Outwards.
    void close(int order, const std::vector<const MatrixXd*>& lower, MatrixXd& highest) const {
        for (const std::size_t side : {0U, 1U}) {
            for (Index ghost = ghosts_[side] - 1; ghost >= 0 && order_of(side) == order; --ghost) {
                for (Index a = 0; a < size_; ++a) {
                    close_ghost(residuals_[side][std::size_t(a)], lower, highest,
                                [&](std::size_t j) { return row_of(side, ghost + Index(j), a); });
                }
            }
        }
    }

    const LateralChain& chain_;
    const Strip& strip_;
    Index size_;  ///< components of a layer
    std::array<const StripSide*, 2> sides_;
    std::array<Index, 2> ghosts_;  ///< layers of each side
    Index all_;                    ///< layers
    /// Of each side with a condition.
    std::array<std::array<ShiftPolynomial, 2>, 2> residuals_;
};

bool has_like_sides(const Strip& strip) {
    const auto* const left = std::get_if<SideCondition>(&strip.left);
    const auto* const right = std::get_if<SideCondition>(&strip.right);
    return left != nullptr && right != nullptr && left->residual == right->residual;
}

}  // namespace

double growth_in_strip(const LateralChain& chain, const Strip& strip) {
    const StripRows rows(chain, strip);
    const Motion motion = rows.motion();
    if (!has_like_sides(strip)) {
        return largest_growth(eigenvalues(motion.map()), strip.time_step);
    }
    double largest = -HUGE_VAL;
    for (const int parity : {1, -1}) {
        const MatrixXd part = motion.map([&](Index row) { return rows.mirror(row, parity); });
        largest = std::max(largest, largest_growth(eigenvalues(part), strip.time_step));
    }
    return largest;
}

std::vector<double> strip_wave_numbers(std::size_t steps) {
    std::vector<double> all;
    for (std::size_t i = 0; i <= steps; ++i) {
        all.push_back(std::numbers::pi * double(i) / double(steps));
    }
    constexpr int halves = 5;
    for (int i = 1; i <= halves; ++i) {
        all.push_back(std::ldexp(std::numbers::pi / double(steps), -i));
    }
    return all;
}

}  // namespace nmbcgen
