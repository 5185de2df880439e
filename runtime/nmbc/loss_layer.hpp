// SPDX-License-Identifier: MIT
/// A layer whose loss rises with the depth: what a sponge and a perfectly matched layer share.
#pragma once

#include <cmath>
#include <cstddef>
#include <nmbc/boundary_condition.hpp>
#include <stdexcept>
#include <vector>

namespace nmbc {

/// It begins half a spacing outside of the outermost interior node, so that its k-th node outwards
/// is at depth (k - 1/2) dX, and the loss there is max ((k - 1/2)/nodes)^profile.
struct LossLayer {
    std::size_t nodes = 0;
    double profile = 2;  ///< exponent, >= 0
    double target = 0;   ///< amplitude that comes back from the far end in the continuum, in (0, 1)
};

/// The largest loss is share (profile + 1) c ln(1/target) / (nodes dX), so that (1/c) times the
/// integral of the loss is share ln(1/target). On the way there and back a loss of the velocity
/// alone takes exp(-(1/c) integral): share 1. One that strain and velocity both have takes
/// exp(-(2/c) integral): share 1/2.
/// Returns loss dt/2 at depths (k - 1/2) dX, k = 1 .. nodes, and once more with the largest of all,
/// beyond the layer.
/// Throws std::invalid_argument where the layer has no node, the profile is negative or the target
/// is not within (0, 1).
inline std::vector<double> half_step_losses(const LossLayer& layer, double share,
                                            const ChainParameters& parameters) {
    if (layer.nodes == 0 || !(layer.profile >= 0) || !std::isfinite(layer.profile) ||
        !(layer.target > 0 && layer.target < 1)) {
        throw std::invalid_argument(
            "an absorbing layer needs a node at least, a profile not below 0 and a target "
            "between 0 and 1");
    }
    const auto nodes = static_cast<double>(layer.nodes);
    const double largest = share * (layer.profile + 1) * parameters.wave_speed() *
                           -std::log(layer.target) / (nodes * parameters.spacing);
    std::vector<double> losses;
    losses.reserve(layer.nodes + 1);
    for (std::size_t k = 1; k <= layer.nodes; ++k) {
        losses.push_back(largest * std::pow((static_cast<double>(k) - 0.5) / nodes, layer.profile) *
                         parameters.time_step / 2);
    }
    losses.push_back(largest * parameters.time_step / 2);
    return losses;
}

}  // namespace nmbc
