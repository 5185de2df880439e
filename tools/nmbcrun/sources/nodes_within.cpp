// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/sources/nodes_within.hpp"

#include <cmath>

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

}  // namespace nmbcrun
