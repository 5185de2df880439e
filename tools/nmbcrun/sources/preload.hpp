// SPDX-License-Identifier: MIT
/// The displacement of a scene's preload.
#pragma once

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// u_s = strain (X - middle of the bar); 0 without a preload.
struct PreloadField {
    explicit PreloadField(const Scene& scene)
        : per_node(scene.preload ? scene.preload->strain * scene.spacing : 0),
          middle((double(scene.nodes) + 1) / 2) {}

    /// node: from 1, as X = node dX [length].
    double operator()(double node) const { return per_node * (node - middle); }

    double per_node;  ///< strain dX [length]
    double middle;    ///< [dX]
};

}  // namespace nmbcrun
