// SPDX-License-Identifier: MIT
/// Exact numbers of a scene.
#pragma once

#include <optional>
#include <string>

#include "tools/nmbcrun/scene/scene_reader.hpp"

namespace nmbcrun {

/// In lowest terms: a string "p/q", or a decimal number as it is written.
std::optional<std::string> read_exact(SceneReader& reader, const std::string& key);

}  // namespace nmbcrun
