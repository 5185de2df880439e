// SPDX-License-Identifier: MIT
/// What is known of the sides of a plane scene before it is run, in words.
#pragma once

#include <optional>
#include <string>

#include "tools/nmbcrun/plane/designed_side.hpp"
#include "tools/nmbcrun/plane/plane_scene.hpp"

namespace nmbcrun {

/// What it rests on that the sides are stable together: "by construction", or "not proved" and why.
std::string evidence_of(const PlaneScene& scene);

/// What comes back from its artificial sides; empty where all are physical. passive: as SceneSides
/// has it.
std::string prospect_of(const PlaneScene& scene, const std::optional<DesignedPassiveSide>& passive);

}  // namespace nmbcrun
