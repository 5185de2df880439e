// SPDX-License-Identifier: MIT
/// The time steps of a scene.
#pragma once

#include <cstddef>
#include <string>

namespace nmbcrun {

/// How long a run is, how its step compares with the interior's limit, and what limits it.
struct StepPlan {
    double time_step = 0;   ///< [time]
    std::size_t steps = 0;  ///< of the whole run
    double cfl = 0;         ///< dt omega_max / 2
    std::string limit{};    ///< what allows no longer step, in words; empty: the scene gives it
};

/// Steps of a run up to time.end. Throws SceneError for more than 1e15.
std::size_t steps_until(double end, double time_step);

/// The step, its cfl and what limits it.
std::string heading_of(const StepPlan& plan);

}  // namespace nmbcrun
