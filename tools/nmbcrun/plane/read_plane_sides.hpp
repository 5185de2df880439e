// SPDX-License-Identifier: MIT
/// The sides of a plane scene, read.
#pragma once

#include "tools/nmbcrun/plane/plane_scene.hpp"
#include "tools/nmbcrun/scene/scene_reader.hpp"

namespace nmbcrun {

/// Names of the sides in a scene, in the order of nmbc::plane_sides.
inline constexpr std::array<std::string_view, 4> side_names{"left", "right", "bottom", "top"};

/// Throws SceneError.
void read_plane_sides(SceneReader& reader, PlaneScene& scene);

}  // namespace nmbcrun
