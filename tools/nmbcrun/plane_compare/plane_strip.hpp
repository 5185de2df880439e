// SPDX-License-Identifier: MIT
/// A plane scene without a dimension that it does not need.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "tools/nmbcrun/plane/plane_scene.hpp"

namespace nmbcrun {

struct PlaneStrip {
    PlaneScene scene;
    std::size_t axis = 0;    ///< along which all is alike
    std::string settings{};  ///< of --set, that make the scene so
};

/// The scene with one node along an axis along which its sides are periodic and all its sources
/// alike, so that it is the chain of its polarisations: u is the same to roundings, energies are
/// those of one line of nodes. None where there is no such axis; of bonds as many nodes as a family
/// reaches.
std::optional<PlaneStrip> strip_of(const PlaneScene& scene);

}  // namespace nmbcrun
