// SPDX-License-Identifier: MIT
/// The file of a plane scene's [initial].
#pragma once

#include "tools/nmbcrun/plane/plane_scene.hpp"
#include "tools/nmbcrun/plane/start_of_nodes.hpp"

namespace nmbcrun {

/// Sets the nodes that the file has: of CSV, rows x, y, ux, uy and, if any, vx, vy, nodes of the
/// scene each; of HDF5, displacement and, if any, velocity, as PlaneFields writes them. Returns
/// whether it has velocities, which are those at -dt/2. Throws SceneError where the file is none of
/// this scene, FileError where it cannot be read.
bool read_initial_fields(const PlaneScene& scene, StartOfNodes& nodes);

}  // namespace nmbcrun
