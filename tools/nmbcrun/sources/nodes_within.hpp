// SPDX-License-Identifier: MIT
/// The nodes that a source acts on.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// The interior nodes with |X - centre| <= half_width [length], counted from 0.
std::vector<std::size_t> nodes_within(const Scene& scene, double centre, double half_width);

}  // namespace nmbcrun
