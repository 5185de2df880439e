// SPDX-License-Identifier: MIT
/// What an absorbing layer sends back of a wave, by its modes.
#pragma once

#include <cstddef>
#include <functional>
#include <nmbc/lattice.hpp>

#include "generator/stability/half_space.hpp"
#include "tools/nmbcrun/scene/boundary.hpp"

namespace nmbcrun {

/// Nodes: of wider layers nothing is told, as it would take long, and the longer the further the
/// lattice reaches.
std::size_t widest_told_layer(const nmbc::Lattice& lattice);

/// The part of the energy of an incident wave that a sponge or a perfectly matched layer sends back
/// in waves of any wave number, as a function of its own [1/dX]: the equations of its nodes in time
/// steps, for waves exp(i theta t/dt), and of those that reach into it, solved for these nodes and
/// for all that goes out of it. half_space: the undamped lattice in the chain's time steps. The
/// function is not for two threads at a time.
std::function<double(double xi)> energy_sent_back_by_layer(const nmbc::Lattice& lattice,
                                                           nmbcgen::HalfSpace half_space,
                                                           const Boundary& boundary);

}  // namespace nmbcrun
