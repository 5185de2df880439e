// SPDX-License-Identifier: MIT
/// What boundaries cost, measured beside the bare interior.
#pragma once

#include <functional>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Time of a step of each of these scenes, which differ in their ends and steps alone, over that of
/// their interior between ends that do nothing. All take turns with the bare interior, and each
/// figure is the median of such pairs. Each scene has its step. after_round is called between two
/// rounds.
std::vector<double> relative_costs(const std::vector<Scene>& scenes,
                                   const std::function<void()>& after_round);

inline constexpr std::size_t cost_rounds = 201;

}  // namespace nmbcrun
