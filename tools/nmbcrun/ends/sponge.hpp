// SPDX-License-Identifier: MIT
/// A sponge: a layer in which the velocity is damped, more and more with the depth.
#pragma once

#include <memory>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/lattice.hpp>
#include <nmbc/loss_layer.hpp>
#include <type_traits>

namespace nmbcrun {

/// In the layer dv/dt = a - gamma v, by the implicit midpoint rule:
///     v+ = ((1 - gamma dt/2) v- + dt a) / (1 + gamma dt/2),
/// gamma = gamma_max (depth/width)^profile at the nodes, gamma_max = (profile + 1) c ln(1/target) /
/// width, so that exp(-(1/c) integral gamma) = target: what the continuum sends back from the far
/// end, where the ghosts are fixed. What the graded loss itself scatters comes on top.
///
/// Leapfrog takes energy out at a rate of gamma v^2, v the mean of the two velocities, and adds
/// none at any gamma: every step up to the interior's limit is stable, damped lattices included.
struct SpongeEnd {
    nmbc::LossLayer layer;

    std::unique_ptr<nmbc::BoundaryCondition<double>> make(
        const nmbc::Lattice& lattice, const nmbc::ChainParameters& parameters,
        std::type_identity<double> precision) const;
};

}  // namespace nmbcrun
