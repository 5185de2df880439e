// SPDX-License-Identifier: MIT
/// What perfectly matched layers need of a plane scene.
#pragma once

#include <string>
#include <vector>

#include "tools/nmbcrun/plane/plane_scene.hpp"

namespace nmbcrun {

/// In words, all that keeps the perfectly matched layers of the scene from running, where the
/// lattice or another side is none for them, or keys of theirs are missing; empty otherwise, and
/// where there are no such layers.
std::string lack_of_matched_layers(const PlaneScene& scene,
                                   const std::vector<std::string>& missing_keys = {});

}  // namespace nmbcrun
