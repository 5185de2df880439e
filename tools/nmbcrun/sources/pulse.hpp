// SPDX-License-Identifier: MIT
/// The shapes of scenes, in space and in wave numbers.
#pragma once

#include "tools/nmbcrun/ends/lattice_wave.hpp"
#include "tools/nmbcrun/scene/sources.hpp"

namespace nmbcrun {

/// The pulse at a distance [length] from its middle.
double value_at(const Pulse& pulse, double distance, double spacing);

/// Of the pulse with its middle at x = middle [dX]; below 1e-18 of its largest value it is 0.
/// Throws SceneError where the width is below a tenth of the spacing or above 1e6 of it.
Transform transform_of(const Pulse& pulse, double middle, double spacing);

/// The pulse is below 1e-16 of its amplitude beyond [dX].
double extent_of(const Pulse& pulse, double spacing);

}  // namespace nmbcrun
