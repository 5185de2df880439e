// SPDX-License-Identifier: MIT
/// The sides of a plane scene, read.
#pragma once

#include "tools/nmbcrun/plane/plane_scene.hpp"
#include "tools/nmbcrun/scene/scene_reader.hpp"

namespace nmbcrun {

/// Throws SceneError.
void read_plane_sides(SceneReader& reader, PlaneScene& scene);

}  // namespace nmbcrun
