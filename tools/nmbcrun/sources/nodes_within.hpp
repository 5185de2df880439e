// SPDX-License-Identifier: MIT
/// The nodes that a source acts on.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// The interior nodes with |X - centre| <= half_width [length], counted from 0.
std::vector<std::size_t> nodes_within(const Scene& scene, double centre, double half_width);

/// Likewise, for a table of the scene whose half_width is in this unit [length]. Throws SceneError
/// where there are none, naming the nearest node and a half_width that reaches it.
std::vector<std::size_t> require_nodes_within(const Scene& scene, double centre, double half_width,
                                              const std::string& table, double unit);

/// The node of an axis that is nearest to a position.
struct NearestNode {
    double at = 0;   ///< its own position [length]
    double off = 0;  ///< how far off it is [length]
};

NearestNode nearest_node(double position, std::size_t nodes, double spacing);

}  // namespace nmbcrun
