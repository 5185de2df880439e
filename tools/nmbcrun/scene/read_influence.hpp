// SPDX-License-Identifier: MIT
/// model.influence: how much a bond counts by its length.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/nmbcrun/scene/scene_reader.hpp"

namespace nmbcrun {

/// w_1 .. w_n as tables have them, "p/q" in lowest terms with w_1 = "1"; none where all are equal,
/// or the key is not there.
std::vector<std::string> read_influence(SceneReader& reader, std::string_view family, int horizon);

}  // namespace nmbcrun
