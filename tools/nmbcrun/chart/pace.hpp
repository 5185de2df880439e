// SPDX-License-Identifier: MIT
/// How fast the machine steps a chain.
#pragma once

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Seconds for a node and a step, of the bare interior on one core.
struct Pace {
    double step_by_step = 0;
    double long_run = 0;  ///< as long_time_stability() steps
};

/// The scene has its step.
Pace pace_of(const Scene& scene);

}  // namespace nmbcrun
