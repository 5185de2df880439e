// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_body.hpp"

namespace nmbcrun {

PlaneBody body_of(const PlaneScene& scene, const std::array<std::size_t, 4>& layers) {
    PlaneBody body{.nodes = scene.nodes};
    for (std::size_t side = 0; side < layers.size(); ++side) {
        const std::size_t added = is_closed(scene.sides[side].kind) ? layers[side] : 0;
        body.nodes[side / 2] += added;
        body.before[side / 2] += side % 2 == 0 ? added : 0;
    }
    return body;
}

}  // namespace nmbcrun
