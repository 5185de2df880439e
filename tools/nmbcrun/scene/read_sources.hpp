// SPDX-License-Identifier: MIT
/// Reads the tables of a scene that start and drive it.
#pragma once

#include <string>

#include "tools/nmbcrun/scene/scene.hpp"
#include "tools/nmbcrun/scene/scene_reader.hpp"

namespace nmbcrun {

/// Sets the scene's sources. path: of the scene file, whose folder those of files are relative to.
/// Throws SceneError where a source is incomplete, has a key that it does not take, or where there
/// is none at all.
void read_sources(SceneReader& reader, const std::string& path, Scene& scene);

}  // namespace nmbcrun
