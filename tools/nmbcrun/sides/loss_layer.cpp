// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/sides/loss_layer.hpp"

#include <cmath>
#include <stdexcept>

namespace nmbcrun {

std::vector<double> half_step_losses(const LossLayer& layer, double share,
                                     const nmbc::ChainParameters& parameters) {
    if (layer.nodes == 0 || !(layer.profile >= 0) || !std::isfinite(layer.profile) ||
        !(layer.target > 0 && layer.target < 1)) {
        throw std::invalid_argument(
            "an absorbing layer needs a node at least, a profile not below 0 and a target "
            "between 0 and 1");
    }
    const auto nodes = double(layer.nodes);
    const double largest = share * (layer.profile + 1) * parameters.wave_speed() *
                           -std::log(layer.target) / (nodes * parameters.spacing);
    std::vector<double> losses;
    losses.reserve(layer.nodes + 1);
    for (std::size_t k = 1; k <= layer.nodes; ++k) {
        losses.push_back(largest * std::pow((double(k) - 0.5) / nodes, layer.profile) *
                         parameters.time_step / 2);
    }
    losses.push_back(largest * parameters.time_step / 2);
    return losses;
}

}  // namespace nmbcrun
