// SPDX-License-Identifier: MIT
/// What moves the nodes of a plane scene, read.
#pragma once

#include <string>

#include "tools/nmbcrun/plane/plane_scene.hpp"
#include "tools/nmbcrun/scene/scene_reader.hpp"

namespace nmbcrun {

/// The start, the force and the drive. path: of the scene, for the files that it names. Throws
/// SceneError.
void read_plane_sources(SceneReader& reader, const std::string& path, PlaneScene& scene);

/// Throws SceneError where the start has nothing within the plane, or the force nothing within the
/// run, but for a tail beyond widths_of_pulse.
void require_plane_sources_inside(const SceneReader& reader, const PlaneScene& scene);

}  // namespace nmbcrun
