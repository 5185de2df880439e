// SPDX-License-Identifier: MIT
/// How long a chart takes.
#pragma once

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// The work of a scene that has its step and like ends, in steps of a plain node, about.
double node_steps(const Scene& scene);

}  // namespace nmbcrun
