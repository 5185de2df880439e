// SPDX-License-Identifier: MIT
/// How far away an end has to be for nothing to return from it.
#pragma once

#include <cstddef>
#include <nmbc/lattice.hpp>

namespace nmbcrun {

/// Nodes that a layer needs so that a wave which enters it at any time up to `duration` [dX/c]
/// does not come back by then, in steps of time_step [dX/c]: half the way of the fastest wave of
/// the fully discrete lattice, and a margin for the tail that runs ahead of it, below 1e-13 of
/// the wave (tests/nmbcrun/exam_silent_layer.cpp).
std::size_t silent_layer(const nmbc::Lattice& lattice, double time_step, double duration);

}  // namespace nmbcrun
