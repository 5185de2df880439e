// SPDX-License-Identifier: MIT
/// Higdon's product of one-way wave equations, on every ghost layer of a line of nodes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/node_line.hpp>
#include <span>
#include <utility>
#include <vector>

namespace nmbc {

/// With K the shift by a node inwards and Z^-1 the one by a step back, by the box scheme: the
/// product over the speeds c of
///     (1 + K)/2 [(1 - Z^-1)/dt + e (1 + Z^-1)/2] - (c/dX) (K - 1) (1 + Z^-1)/2,   e the decay,
/// times u is 0, at each ghost node from the innermost outwards. With one speed and no decay it is
/// (58) with midpoint ghosts, NMBC1 of stride 1.
///
/// It remembers u at the levels before, the latest first, on the ghosts and as many nodes more as
/// there are speeds.
template <class Real>
class HigdonCondition final : public BoundaryCondition<Real> {
  public:
    /// courants: c dt/dX of each speed; damping: e dt/2.
    HigdonCondition(std::size_t ghosts, std::span<const double> courants, double damping,
                    double time_step)
        : ghosts_(ghosts),
          order_(courants.size()),
          time_step_(static_cast<Real>(time_step)),
          product_(product(courants, damping)),
          earlier_((order_ - 1) * width()) {}

    std::size_t least_interior_nodes() const override { return order_; }

    /// As if the nodes had come with these velocities.
    void start(NodeLine<Real> u, NodeLine<Real> v, std::size_t /*step*/) override {
        for (std::size_t m = 1; m < order_; ++m) {
            for (std::size_t node = 0; node < width(); ++node) {
                earlier(m, node) = u[node] - static_cast<Real>(m) * time_step_ * v[node];
            }
        }
    }

    void after_kick(NodeLine<const Real> u, NodeLine<Real> v, std::size_t /*step*/) override {
        for (std::size_t ghost = ghosts_; ghost-- > 0;) {
            // u at the new level is u + dt v: its u goes to those of Z^-1.
            Real known = 0;
            Real velocities = 0;
            for (std::size_t j = 0; j <= order_; ++j) {
                known += (product_[j][0] + product_[j][1]) * u[ghost + j];
                velocities += j == 0 ? 0 : product_[j][0] * v[ghost + j];
                for (std::size_t m = 2; m <= order_; ++m) {
                    known += product_[j][m] * earlier(m - 1, ghost + j);
                }
            }
            v[ghost] = -velocities - known / time_step_;
        }
        if (order_ == 1) {
            return;
        }
        std::ranges::copy_backward(std::span(earlier_).first(earlier_.size() - width()),
                                   earlier_.end());
        for (std::size_t node = 0; node < width(); ++node) {
            earlier(1, node) = u[node];
        }
    }

    std::span<const Real> memory() const override { return earlier_; }
    void remember(std::span<const Real> memory) override {
        std::ranges::copy(memory, earlier_.begin());
    }

  private:
    using Rows = std::vector<std::vector<Real>>;

    /// Entry (j, m) of K^j Z^-m in the product, each factor times 2 dt over its own entry (0, 0).
    static Rows product(std::span<const double> courants, double damping) {
        const std::size_t order = courants.size();
        std::vector<std::vector<double>> result(order + 1, std::vector<double>(order + 1));
        result[0][0] = 1;
        for (const double courant : courants) {
            const double first = 1 + damping + courant;
            const double inwards = (1 + damping - courant) / first;
            const double back = (1 - damping - courant) / first;
            const double both = (1 - damping + courant) / first;
            for (std::size_t j = order + 1; j-- > 0;) {
                for (std::size_t m = order + 1; m-- > 0;) {
                    const double shifted = j > 0 ? result[j - 1][m] : 0;
                    const double older = m > 0 ? result[j][m - 1] : 0;
                    const double last = j > 0 && m > 0 ? result[j - 1][m - 1] : 0;
                    result[j][m] += inwards * shifted - back * older - both * last;
                }
            }
        }
        Rows rows;
        for (const std::vector<double>& row : result) {
            auto& rounded = rows.emplace_back();
            std::ranges::transform(row, std::back_inserter(rounded),
                                   [](double entry) { return static_cast<Real>(entry); });
        }
        return rows;
    }

    std::size_t width() const { return ghosts_ + order_; }

    /// u, m steps before the present level.
    Real& earlier(std::size_t m, std::size_t node) { return earlier_[(m - 1) * width() + node]; }

    std::size_t ghosts_;
    std::size_t order_;
    Real time_step_;
    Rows product_;
    std::vector<Real> earlier_;
};

}  // namespace nmbc
