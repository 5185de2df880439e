// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/ends/sponge.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace nmbcrun {
namespace {

using Field = nmbc::NodeLine<double>;

class SpongeCondition final : public nmbc::BoundaryCondition<double> {
  public:
    /// losses: gamma dt/2, from the interior outwards.
    SpongeCondition(std::size_t ghosts, std::vector<double> losses)
        : ghosts_(ghosts), losses_(std::move(losses)), old_velocities_(losses_.size()) {
        std::ranges::reverse(losses_);
    }

    std::size_t layer_nodes() const override { return losses_.size(); }

    void start(Field u, Field v, std::size_t /*step*/) override {
        for (std::size_t ghost = 0; ghost < ghosts_; ++ghost) {
            u[ghost] = 0;
            v[ghost] = 0;
        }
        for (std::size_t i = 0; i < losses_.size(); ++i) {
            old_velocities_[i] = v[ghosts_ + i];
        }
    }

    void after_kick(nmbc::NodeLine<const double> /*u*/, Field v, std::size_t /*step*/) override {
        for (std::size_t ghost = 0; ghost < ghosts_; ++ghost) {
            v[ghost] = 0;
        }
        for (std::size_t i = 0; i < losses_.size(); ++i) {
            double& velocity = v[ghosts_ + i];
            velocity = (velocity - losses_[i] * old_velocities_[i]) / (1 + losses_[i]);
            old_velocities_[i] = velocity;
        }
    }

    std::span<const double> memory() const override { return old_velocities_; }
    void remember(std::span<const double> memory) override {
        std::ranges::copy(memory, old_velocities_.begin());
    }

  private:
    std::size_t ghosts_;
    std::vector<double> losses_;  // from the outermost node of the layer inwards
    std::vector<double> old_velocities_;
};

}  // namespace

std::unique_ptr<nmbc::BoundaryCondition<double>> SpongeEnd::make(
    const nmbc::Lattice& lattice, const nmbc::ChainParameters& parameters,
    std::type_identity<double> /*precision*/) const {
    std::vector<double> losses = nmbc::half_step_losses(layer, 1, parameters);
    losses.pop_back();  // there are no squares of its own beyond the layer
    return std::make_unique<SpongeCondition>(lattice.reach(), std::move(losses));
}

}  // namespace nmbcrun
