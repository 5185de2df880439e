// SPDX-License-Identifier: MIT
/// A perfectly matched layer of a lattice, made of the squares of its energy.
#pragma once

#include <memory>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/lattice.hpp>
#include <nmbc/loss_layer.hpp>
#include <type_traits>

namespace nmbcrun {

/// The lattice's energy is a sum of squares, so its equation of motion is
///     v' = -(c/dX) sum_q L_q^T p_q,    p_q' = (c/dX) w_q L_q v,    p_q = (c/dX) w_q L_q u.
/// In the layer both have loss, v' + sigma v = .. and p_q' + sigma p_q = .., and the p_q are
/// unknowns of their own: at the frequency omega every L_q is divided by 1 + sigma/(i omega), the
/// complex stretch of the coordinate. This is the layer that Wildman & Gazonas 2011 made for
/// peridynamics in one dimension, but in first-order form and with the lattice's own operators.
///
/// A wave loses exp(-integral sigma / group velocity) on its way out, and as much back from the far
/// end, where the ghosts are fixed; sigma = sigma_max (depth/width)^profile at the nodes and
/// squares, sigma_max = (profile + 1) c ln(1/target) / (2 width), makes this `target` for long
/// waves. A constant sigma is exactly matched within the layer alone: at its beginning and wherever
/// sigma changes within the reach of an L_q, the stretch does not commute with L_q, and some is
/// sent back, of short waves most. L_q of the stabilisation are higher differences than the
/// strain's, and stretched alike, each by one factor for the whole stencil, that of its middle
/// node. The damping force of a damped lattice acts on in the layer as it is, unstretched: of order
/// xi^4.
///
/// Leapfrog with v at half levels, p at whole ones and the trapezoidal rule for both losses. In
/// units dX = c = 1, a step takes dt (sum sigma v^2 + sum sigma p^2/w), v and p the means of old
/// and new, from the energy
///     sum v^2/2 + sum (p^2/w - dt p L v)/2,   p half a step after v, over all nodes and squares.
/// It is positive below the interior's limit of the time step, so nothing grows at any sigma, n or
/// G, with backward waves or without. (Of a damped lattice, less dt/4 v.tau sigma v, likewise.)
struct PmlEnd {
    nmbc::LossLayer layer;

    /// Throws std::invalid_argument where the lattice has no squares or one of negative weight, and
    /// as half_step_losses does.
    /// What the end remembers: v of the layer's nodes at t - dt/2, then p at t of every square, by
    /// q and from the outermost centre inwards.
    std::unique_ptr<nmbc::BoundaryCondition<double>> make(
        const nmbc::Lattice& lattice, const nmbc::ChainParameters& parameters,
        std::type_identity<double> precision) const;
};

}  // namespace nmbcrun
