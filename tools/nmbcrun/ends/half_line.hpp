// SPDX-License-Identifier: MIT
/// How the lattice goes on beyond an end of a scene.
#pragma once

#include <cstddef>
#include <nmbc/lattice.hpp>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Nodes between the interior and the ghosts of an end of the scene, in steps of time_step [dX/c]:
/// of an extended end that is given none, silent_layer() of the run.
std::size_t layer_of(const Scene& scene, const Boundary& boundary, const nmbc::Lattice& lattice,
                     double time_step);

/// Whether the lattice as good as goes on for ever beyond this end of the scene: in a run of steps
/// of time_step [dX/c] nothing that went out there comes back.
bool is_half_line(const Scene& scene, const Boundary& boundary, const nmbc::Lattice& lattice,
                  double time_step);

}  // namespace nmbcrun
