// SPDX-License-Identifier: MIT
/// nmbcrun advise, of a plane scene: the smallest model that meets a tolerance.
#pragma once

#include "tools/nmbcrun/plane/plane_scene.hpp"

namespace nmbcrun {

/// The scene without a dimension that it does not need, between the sides that cost its run least
/// of those that are stable by construction and err by no more than the tolerance, max |u - u_ref|
/// over max |u_ref| as measure_sides() finds it; and a line that says which. Throws as
/// measure_sides() does.
PlaneScene as_advised(const PlaneScene& scene, double tolerance, bool quiet);

/// Prints the advice, ranked, and what was left out and why.
void advise_plane(const PlaneScene& scene, double tolerance, bool quiet);

}  // namespace nmbcrun
