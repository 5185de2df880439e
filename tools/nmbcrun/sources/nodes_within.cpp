// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/sources/nodes_within.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/sources/two_digits.hpp"

namespace nmbcrun {

std::vector<std::size_t> nodes_within(const Scene& scene, double centre, double half_width) {
    // Positions are rounded; a billionth of a spacing decides nothing on purpose.
    const double slack = 1e-9 * scene.spacing;
    std::vector<std::size_t> nodes;
    for (std::size_t node = 0; node < scene.nodes; ++node) {
        const double X = double(node + 1) * scene.spacing;
        if (std::abs(X - centre) <= half_width + slack) {
            nodes.push_back(node);
        }
    }
    return nodes;
}

std::vector<std::size_t> require_nodes_within(const Scene& scene, double centre, double half_width,
                                              const std::string& table, double unit) {
    std::vector<std::size_t> nodes = nodes_within(scene, centre, half_width * unit);
    if (nodes.empty()) {
        const auto [at, off] = nearest_node(centre, scene.nodes, scene.spacing);
        if (off > scene.spacing) {
            throw SceneError(fmt::format(
                "{0}.centre and {0}.half_width select no node: the nodes are at X = {1:g} to {2:g}",
                table, scene.spacing, double(scene.nodes) * scene.spacing));
        }
        throw SceneError(fmt::format(
            "{0}.centre and {0}.half_width select no node: the nearest is at X = {1:g}, and "
            "{0}.half_width = {2:g} would select it",
            table, at, two_digits(off / unit, false)));
    }
    return nodes;
}

NearestNode nearest_node(double position, std::size_t nodes, double spacing) {
    const double at = spacing * std::clamp(std::round(position / spacing), 1.0, double(nodes));
    return {.at = at, .off = std::abs(position - at)};
}

}  // namespace nmbcrun
