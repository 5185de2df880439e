// SPDX-License-Identifier: MIT
/// The sides of a plane scene, as the runtime takes them.
#pragma once

#include <nmbc/plane_sides.hpp>

#include "tools/nmbcrun/plane/plane_scene.hpp"

namespace nmbcrun {

/// Designs passive sides, which takes a second at radius 1 and 20 s at radius 3. Throws SceneError
/// where the scene asks for what there is not, and Unstable of sides that may feed energy in,
/// unless it allows them.
nmbc::PlaneSides sides_of(const PlaneScene& scene);

}  // namespace nmbcrun
