// SPDX-License-Identifier: MIT
/// How far away an end has to be for nothing to return from it.
#pragma once

#include <cstddef>
#include <nmbc/lattice.hpp>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Nodes that a layer needs so that a wave which enters it at any time up to `duration` [dX/c]
/// does not come back by then, in steps of time_step [dX/c]: half the way of the fastest wave of
/// the fully discrete lattice, and a margin for the tail that runs ahead of it, below 1e-13 of
/// the wave (tests/nmbcrun/exam_silent_layer.cpp).
std::size_t silent_layer(const nmbc::Lattice& lattice, double time_step, double duration);

/// Nodes between the interior and the ghosts of an end of the scene, in steps of time_step [dX/c]:
/// of an extended end that is given none, silent_layer() of the run.
std::size_t layer_of(const Scene& scene, const Boundary& boundary, const nmbc::Lattice& lattice,
                     double time_step);

/// Whether the lattice as good as goes on for ever beyond this end of the scene: in a run of steps
/// of time_step [dX/c] nothing that went out there comes back.
bool is_half_line(const Scene& scene, const Boundary& boundary, const nmbc::Lattice& lattice,
                  double time_step);

}  // namespace nmbcrun
