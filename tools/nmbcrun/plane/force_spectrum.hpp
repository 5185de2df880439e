// SPDX-License-Identifier: MIT
/// What waves a body force of a plane scene sends out.
#pragma once

#include "tools/nmbcrun/plane/plane_scene.hpp"

namespace nmbcrun {

/// The part of the energy that the force gives an endless lattice, in waves that are much slower or
/// faster than those of the solid, or go backwards; 0 where there is no force, one from a file, or
/// one of more nodes than waves are short.
double not_carried(const PlaneScene& scene);

}  // namespace nmbcrun
