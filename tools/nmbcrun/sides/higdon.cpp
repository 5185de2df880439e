// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/sides/higdon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

namespace nmbcrun {
namespace {

using Field = nmbc::NodeLine<double>;
using Fixed = nmbc::NodeLine<const double>;
using Rows = std::vector<std::vector<double>>;

/// Entry (j, m) of K^j Z^-m in (1 + r K - r Z^-1 - K Z^-1)^order, r = (1 - courant)/(1 + courant):
/// each factor is the box scheme's times 2 dt/(1 + courant).
Rows product(std::size_t order, double courant) {
    const double r = (1 - courant) / (1 + courant);
    Rows result(order + 1, std::vector<double>(order + 1));
    result[0][0] = 1;
    for (std::size_t factor = 0; factor < order; ++factor) {
        for (std::size_t j = order + 1; j-- > 0;) {
            for (std::size_t m = order + 1; m-- > 0;) {
                const double shifted = j > 0 ? result[j - 1][m] : 0;
                const double older = m > 0 ? result[j][m - 1] : 0;
                const double both = j > 0 && m > 0 ? result[j - 1][m - 1] : 0;
                result[j][m] += r * (shifted - older) - both;
            }
        }
    }
    return result;
}

class HigdonCondition final : public nmbc::BoundaryCondition<double> {
  public:
    HigdonCondition(std::size_t ghosts, std::size_t order, const nmbc::ChainParameters& p)
        : ghosts_(ghosts),
          order_(order),
          time_step_(p.time_step),
          product_(product(order, p.time_step * p.wave_speed() / p.spacing)),
          earlier_((order - 1) * width()) {}

    std::size_t least_interior_nodes() const override { return order_; }

    /// As if the nodes had come with these velocities.
    void start(Field u, Field v) override {
        for (std::size_t m = 1; m < order_; ++m) {
            for (std::size_t node = 0; node < width(); ++node) {
                earlier(m, node) = u[node] - double(m) * time_step_ * v[node];
            }
        }
    }

    void after_kick(Fixed u, Field v, std::size_t /*step*/) override {
        for (std::size_t ghost = ghosts_; ghost-- > 0;) {
            // u at the new level is u + dt v: its u goes to those of Z^-1.
            double known = 0;
            double velocities = 0;
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

    std::span<const double> memory() const override { return earlier_; }
    void remember(std::span<const double> memory) override {
        std::ranges::copy(memory, earlier_.begin());
    }

  private:
    std::size_t width() const { return ghosts_ + order_; }

    /// u, m steps before the present level.
    double& earlier(std::size_t m, std::size_t node) { return earlier_[(m - 1) * width() + node]; }

    std::size_t ghosts_;
    std::size_t order_;
    double time_step_;
    Rows product_;
    std::vector<double> earlier_;
};

}  // namespace

std::unique_ptr<nmbc::BoundaryCondition<double>> HigdonEnd::make(
    const nmbc::Lattice& lattice, const nmbc::ChainParameters& parameters,
    std::type_identity<double> /*precision*/) const {
    if (order < 1 || order > highest_order) {
        throw std::invalid_argument(
            fmt::format("the order of a higdon end is 1 to {}, not {}", highest_order, order));
    }
    return std::make_unique<HigdonCondition>(lattice.reach(), std::size_t(order), parameters);
}

}  // namespace nmbcrun
