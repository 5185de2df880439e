// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/ends/pml.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

namespace nmbcrun {
namespace {

using Field = nmbc::NodeLine<double>;
using Fixed = nmbc::NodeLine<const double>;
using Square = nmbc::Lattice::Square;

class PmlCondition final : public nmbc::BoundaryCondition<double> {
  public:
    /// losses: sigma dt/2, from the interior outwards, and the largest. step: dt c/dX. The
    /// lattice's squares have their mirror images: an end need not know whether it is the left one.
    PmlCondition(const nmbc::Lattice& lattice, std::span<const double> losses, double rate,
                 double time_step)
        : ghosts_(lattice.reach()),
          layer_(losses.size() - 1),
          rate_(rate),
          step_(rate * time_step),
          squares_(lattice.energy) {
        for (std::size_t node = 0; node < ghosts_ + layer_; ++node) {
            losses_.push_back(losses[std::min(ghosts_ + layer_ - 1 - node, layer_)]);
        }
        std::size_t fields = 0;
        for (const Square& square : squares_) {
            half_width_ = std::max(half_width_, square.stencil.size() / 2);
            fields += layer_ + square.stencil.size() / 2;
        }
        memory_.resize(layer_ + fields);
    }

    std::size_t layer_nodes() const override { return layer_; }
    std::size_t least_interior_nodes() const override { return half_width_; }

    void start(Field u, Field v, std::size_t /*step*/) override {
        for (std::size_t ghost = 0; ghost < ghosts_; ++ghost) {
            u[ghost] = 0;
            v[ghost] = 0;
        }
        for (std::size_t i = 0; i < layer_; ++i) {
            memory_[i] = v[ghosts_ + i];
        }
        const Fixed now = u;
        for_each_square([&](const Square& square, std::size_t centre, double& p) {
            p = rate_ * square.weight * apply(square, centre, now);
        });
    }

    void after_kick(Fixed u, Field v, std::size_t /*step*/) override {
        // The uniform lattice has kicked with (c/dX) w L u in the place of p.
        for_each_square([&](const Square& square, std::size_t centre, double p) {
            const double excess = step_ * (p - rate_ * square.weight * apply(square, centre, u));
            for_each_node(square, centre,
                          [&](double entry, std::size_t node) { v[node] -= entry * excess; });
        });
        for (std::size_t ghost = 0; ghost < ghosts_; ++ghost) {
            v[ghost] = 0;
        }
        for (std::size_t i = 0; i < layer_; ++i) {
            const double loss = losses_[ghosts_ + i];
            double& velocity = v[ghosts_ + i];
            velocity = (velocity - loss * memory_[i]) / (1 + loss);
            memory_[i] = velocity;
        }
        const Fixed moved = v;
        for_each_square([&](const Square& square, std::size_t centre, double& p) {
            const double loss = losses_[centre];
            p = ((1 - loss) * p + step_ * square.weight * apply(square, centre, moved)) /
                (1 + loss);
        });
    }

    std::span<const double> memory() const override { return memory_; }
    void remember(std::span<const double> memory) override {
        std::ranges::copy(memory, memory_.begin());
    }

  private:
    /// Calls with each square that touches a node of the layer and has its middle there or beyond,
    /// and with its p.
    template <class Visit>
    void for_each_square(Visit&& visit) {
        double* p = memory_.data() + layer_;
        for (const Square& square : squares_) {
            const std::size_t first = ghosts_ - square.stencil.size() / 2;
            for (std::size_t centre = first; centre < ghosts_ + layer_; ++centre) {
                visit(square, centre, *p++);
            }
        }
    }

    /// Calls with the entries of the stencil and their nodes, ghosts (where all is 0) left out.
    template <class Visit>
    void for_each_node(const Square& square, std::size_t centre, Visit&& visit) const {
        const std::size_t half_width = square.stencil.size() / 2;
        for (std::size_t i = 0; i < square.stencil.size(); ++i) {
            if (centre + i >= ghosts_ + half_width) {
                visit(square.stencil[i], centre + i - half_width);
            }
        }
    }

    double apply(const Square& square, std::size_t centre, Fixed field) const {
        double sum = 0;
        for_each_node(square, centre,
                      [&](double entry, std::size_t node) { sum += entry * field[node]; });
        return sum;
    }

    std::size_t ghosts_;
    std::size_t layer_;
    double rate_;                 // c/dX
    double step_;                 // dt c/dX
    std::vector<double> losses_;  // of ghosts and layer, from the outermost inwards
    std::vector<Square> squares_;
    std::size_t half_width_ = 1;  // of the widest
    std::vector<double> memory_;
};

}  // namespace

std::unique_ptr<nmbc::BoundaryCondition<double>> PmlEnd::make(
    const nmbc::Lattice& lattice, const nmbc::ChainParameters& parameters,
    std::type_identity<double> /*precision*/) const {
    if (lattice.energy.empty() ||
        std::ranges::any_of(lattice.energy, [](const Square& q) { return q.weight < 0; })) {
        throw std::invalid_argument(
            "a perfectly matched layer needs a lattice whose energy is a sum of squares, none of "
            "them with a negative weight");
    }
    return std::make_unique<PmlCondition>(lattice, nmbc::half_step_losses(layer, 0.5, parameters),
                                          parameters.wave_speed() / parameters.spacing,
                                          parameters.time_step);
}

}  // namespace nmbcrun
