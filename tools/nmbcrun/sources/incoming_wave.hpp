// SPDX-License-Identifier: MIT
/// The wave of a scene's [incoming] as a sum of lattice waves.
#pragma once

#include <nmbc/boundary_condition.hpp>
#include <nmbc/lattice.hpp>

#include "tools/nmbcrun/ends/incident_field.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Adds it to the incident field of its end: components whose energy travels inwards, so many that
/// the sum does not repeat before the wave has passed that end, or before the run of so many steps
/// ends. Throws SceneError where the lattice is damped, the width out of bounds, or more than 100
/// 000 components would be needed.
void add_incoming_wave(const Scene& scene, const nmbc::Lattice& lattice,
                       const nmbc::ChainParameters& parameters, std::size_t steps,
                       IncidentField& incident);

/// How much of a wave of this group velocity [c] comes in, 0 to 1: those that hardly move do not.
double share_of_incoming(double speed);

}  // namespace nmbcrun
