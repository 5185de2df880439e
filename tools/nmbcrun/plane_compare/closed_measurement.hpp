// SPDX-License-Identifier: MIT
/// What the sides that end a plane's body cost, and how good they are.
#pragma once

#include <vector>

#include "tools/nmbcrun/plane/plane_scene.hpp"
#include "tools/nmbcrun/plane_compare/side_points.hpp"

namespace nmbcrun {

/// Closes the body of a scene without artificial sides by each kind that its lattice has, sbp,
/// kernel and free, on lattices of one dX that fit it, all in the same steps, and compares with
/// finer_run(), in one unit, the largest |u_ref|. Times each beside fixed sides. What does not fit
/// is left out, and named on stderr. Throws SceneError where no side ends the body, it has one kind
/// only or none fits, as finer_body() and finer_run() do, Unstable where nothing moves, and
/// Interrupted.
std::vector<SidePoint> measure_closed_sides(const PlaneScene& scene, bool quiet);

}  // namespace nmbcrun
