// SPDX-License-Identifier: MIT
/// The sides of a plane scene, as the runtime takes them.
#pragma once

#include <nmbc/plane_sides.hpp>
#include <optional>

#include "tools/nmbcrun/plane/designed_side.hpp"
#include "tools/nmbcrun/plane/plane_scene.hpp"

namespace nmbcrun {

struct SceneSides {
    nmbc::PlaneSides all;
    std::optional<DesignedPassiveSide> passive{};  ///< of the passive ones, if there are any
};

/// Designs passive sides, which takes as long as nmbcgen::passive_side(); a terminal shows
/// how far it is, unless quiet. Throws SceneError where the scene asks for what there is not, and
/// Unstable of sides that may feed energy in, unless it allows them.
SceneSides sides_of(const PlaneScene& scene, bool quiet);

}  // namespace nmbcrun
