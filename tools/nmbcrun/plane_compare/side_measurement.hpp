// SPDX-License-Identifier: MIT
/// What sides cost a plane scene, and how good they are.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/nmbcrun/plane/plane_scene.hpp"
#include "tools/nmbcrun/plane_compare/side_candidates.hpp"
#include "tools/nmbcrun/plane_compare/side_points.hpp"

namespace nmbcrun {

/// Runs the scene with each candidate in the place of its artificial sides, all in the same steps,
/// and compares with sides so far off that nothing returns; layers have the losses that err least.
/// Times each beside fixed sides, and follows those that may feed energy in through a long run of a
/// small box. What the scene cannot have is left out, and named on stderr.
/// Throws as PlaneSimulation does, Unstable where nothing moves, and Interrupted.
std::vector<SidePoint> measure_sides(const PlaneScene& scene,
                                     const std::vector<SideCandidate>& candidates,
                                     std::size_t long_run, bool quiet);

}  // namespace nmbcrun
