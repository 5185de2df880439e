// SPDX-License-Identifier: MIT
/// The nodes that are the body of a plane scene.
#pragma once

#include <array>
#include <cstddef>

#include "tools/nmbcrun/plane/plane_scene.hpp"

namespace nmbcrun {

/// The scene's nodes and those that closed sides add. Layers of other sides are no part of it: they
/// stand for what goes on beyond.
struct PlaneBody {
    std::array<std::size_t, 2> before{};  ///< added at the low sides
    std::array<std::size_t, 2> nodes{};   ///< along each axis
};

/// layers: of the plane's sides.
PlaneBody body_of(const PlaneScene& scene, const std::array<std::size_t, 4>& layers);

}  // namespace nmbcrun
