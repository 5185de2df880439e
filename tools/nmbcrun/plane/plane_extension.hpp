// SPDX-License-Identifier: MIT
/// How many nodes extended sides add to a plane scene.
#pragma once

#include <array>
#include <cstddef>

#include "tools/nmbcrun/plane/plane_scene.hpp"

namespace nmbcrun {

/// Layers that extended sides add to the scene's nodes, in the order of plane_sides: their own, or
/// as many as it takes until time.end. Throws SceneError where the plane has more than most_nodes
/// with these and the layers of other sides.
std::array<std::size_t, 4> extension_of(const PlaneScene& scene);

/// Throws as extension_of().
void require_room(const PlaneScene& scene);

}  // namespace nmbcrun
