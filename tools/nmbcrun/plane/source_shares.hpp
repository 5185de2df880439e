// SPDX-License-Identifier: MIT
/// What nodes of a body have of a source that is given on another lattice.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/nmbcrun/plane/plane_body.hpp"

namespace nmbcrun {

/// A node of the scene, from 0; those that closed sides add are below 0 and beyond its last one.
struct NodeShare {
    std::ptrdiff_t x = 0;
    std::ptrdiff_t y = 0;
    double share = 0;         ///< above 0, up to 1
    bool is_between = false;  ///< the original's nodes, and not beyond the outermost ones
};

/// Of the nodes of a scene with an original: 1 on the chosen nodes of the original, row by row, 0
/// on its others, and linear along each axis between them. Beyond the outermost ones it goes on as
/// the original's sides have it.
std::vector<NodeShare> shares_of(const PlaneScene& scene, const PlaneBody& body,
                                 const std::vector<bool>& chosen);

}  // namespace nmbcrun
