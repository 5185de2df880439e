// SPDX-License-Identifier: MIT
/// What boundaries cost, measured beside the bare interior.
#pragma once

#include <functional>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Time of a step with each of these ends over that of the interior between ends that do nothing,
/// in the order given. All take turns with the bare interior, in steps of the scene's own length,
/// and each figure is the median of such pairs. after_round is called between two rounds.
std::vector<double> relative_costs(const Scene& scene, const std::vector<Boundary>& boundaries,
                                   const std::function<void()>& after_round);

inline constexpr std::size_t cost_rounds = 201;

}  // namespace nmbcrun
