// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/ends/exact.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tools/nmbcrun/ends/online_convolution.hpp"
#include "tools/nmbcrun/ends/transparent_kernel.hpp"

namespace nmbcrun {
namespace {

using nmbc::NodeLine;

class ExactCondition final : public nmbc::BoundaryCondition<double> {
  public:
    ExactCondition(OnlineConvolution convolution, const nmbc::ChainParameters& p)
        : convolution_(std::move(convolution)),
          time_step_(p.time_step),
          unit_of_time_(p.spacing / p.wave_speed()),
          interior_nodes_(p.nodes),
          near_(convolution_.inputs()),
          ghosts_(convolution_.reach()) {}

    std::size_t least_interior_nodes() const override { return convolution_.reach(); }

    void start(NodeLine<double> u, NodeLine<double> v, std::size_t /*step*/) override {
        require_rest(u, v);
        for (std::size_t ghost = 0; ghost < convolution_.reach(); ++ghost) {
            u[ghost] = 0;
            v[ghost] = 0;
        }
        convolution_.clear();
    }

    void after_kick(NodeLine<const double> u, NodeLine<double> v, std::size_t /*step*/) override {
        if (convolution_.levels() == convolution_.steps()) {
            throw std::length_error("the exact end was made for " +
                                    std::to_string(convolution_.steps()) + " steps, and no more");
        }
        for (std::size_t node = 0; node < near_.size(); ++node) {
            near_[node] = u[node + 1];
        }
        convolution_.advance(near_, ghosts_);
        for (std::size_t ghost = 0; ghost < ghosts_.size(); ++ghost) {
            v[ghost] = (ghosts_[ghost] - u[ghost]) / time_step_;
        }
    }

    std::span<const double> memory() const override { return convolution_.memory(); }
    void remember(std::span<const double> memory) override { convolution_.remember(memory); }

  private:
    void require_rest(NodeLine<double> u, NodeLine<double> v) const {
        const auto size_at = [&](std::size_t node) {
            return std::max(std::abs(u[node]), std::abs(v[node]) * unit_of_time_);
        };
        double largest = 0;
        for (std::size_t node = 0; node < convolution_.reach() + interior_nodes_; ++node) {
            largest = std::max(largest, size_at(node));
        }
        constexpr double negligible = 1e-12;  // what the kernel is right to
        for (std::size_t node = 0; node < 2 * convolution_.reach(); ++node) {
            if (size_at(node) > negligible * largest) {
                throw std::invalid_argument(
                    "an exact end starts from rest: u and v must be 0 (1e-12 of the largest) at "
                    "its ghosts and the " +
                    std::to_string(convolution_.reach()) +
                    " interior nodes next to them, also when the chain is written to, or asked for "
                    "fields to write to, between two steps");
            }
        }
    }

    OnlineConvolution convolution_;
    double time_step_;
    double unit_of_time_;  // dX/c
    std::size_t interior_nodes_;
    std::vector<double> near_;
    std::vector<double> ghosts_;
};

}  // namespace

std::unique_ptr<nmbc::BoundaryCondition<double>> ExactEnd::make(
    const nmbc::Lattice& lattice, const nmbc::ChainParameters& parameters,
    std::type_identity<double> /*precision*/) const {
    if (steps < 1 || steps > most_steps) {
        throw std::invalid_argument("an exact end is made for 1 to " + std::to_string(most_steps) +
                                    " steps, not " + std::to_string(steps));
    }
    const double courant = parameters.wave_speed() * parameters.time_step / parameters.spacing;
    return std::make_unique<ExactCondition>(
        OnlineConvolution(transparent_kernel(lattice, courant, steps)), parameters);
}

}  // namespace nmbcrun
