// SPDX-License-Identifier: MIT
/// Runs whose steps are many or very short.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/nmbcrun/scene/step_plan.hpp"

namespace nmbcrun {

/// In words: where the steps are far below what the lattice allows, where it allows none but very
/// short ones, and where so many are left that they take more than an hour with so many nodes.
/// unit_of_time: dX/c.
std::vector<std::string> warnings_of_steps(const StepPlan& plan, double unit_of_time,
                                           std::size_t steps_left, std::size_t nodes);

}  // namespace nmbcrun
