// SPDX-License-Identifier: MIT
/// A layer whose loss rises with the depth: what a sponge and a perfectly matched layer share.
#pragma once

#include <cstddef>
#include <nmbc/end_condition.hpp>
#include <vector>

namespace nmbcrun {

/// It begins half a spacing outside of the outermost interior node, so that its k-th node outwards
/// is at depth (k - 1/2) dX, and the loss there is max ((k - 1/2)/nodes)^profile.
struct LossLayer {
    std::size_t nodes = 0;
    double profile = 2;  ///< exponent, >= 0
    double target = 0;   ///< amplitude that comes back from the far end in the continuum, in (0, 1)
};

/// The integral over the layer of a loss [1/time] whose largest value is 1, by c: profile and
/// spacing give nodes dX / ((profile + 1) c) [time].
/// rate_factor: the loss that divides the amplitude by e on a round trip, times c/2 per length: 1
/// of a loss of the velocity alone, exp(-(1/c) integral gamma); 1/2 of one that strain and velocity
/// share, exp(-(2/c) integral sigma).
/// Returns loss dt/2 at depths (k - 1/2) dX, k = 1 .. nodes, and once more with the largest of all,
/// beyond the layer.
/// Throws std::invalid_argument where the layer has no node, the profile is negative or the target
/// is not within (0, 1).
std::vector<double> half_step_losses(const LossLayer& layer, double rate_factor,
                                     const nmbc::ChainParameters& parameters);

}  // namespace nmbcrun
