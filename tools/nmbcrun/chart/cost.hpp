// SPDX-License-Identifier: MIT
/// What boundaries cost, measured beside the bare interior.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

inline constexpr std::size_t cost_rounds = 101;
inline constexpr std::size_t making_rounds = 51;
inline constexpr double enough_timed = 0.5;  ///< [s]: what takes long needs fewer rounds

/// What a run takes, in steps of the bare interior.
struct RelativeCost {
    double step = 0;          ///< each step, in the mean of the run
    double construction = 0;  ///< to make both ends, before the first one

    double of_run(std::size_t steps) const { return step * double(steps) + construction; }
};

/// Of each of these scenes, which differ in their ends and steps alone, beside their interior
/// between ends that do nothing. All take turns with the bare interior, and each figure is the
/// median of such pairs. Each scene has its step, and the end of its run. after_round is called
/// between two of the rounds of the steps, pause between two of each measurement: both may throw.
std::vector<RelativeCost> relative_costs(
    const std::vector<Scene>& scenes, const std::function<void()>& after_round,
    const std::function<void()>& pause = [] {}, std::size_t rounds = cost_rounds);

/// Nodes times steps, of the bare interior, between two looks at the clock: a twentieth of a
/// millisecond or so, mostly undisturbed where other programs run, too. Too few for the field to
/// fade, or to grow beyond all doubles.
inline constexpr double timing_burst = 5e4;

}  // namespace nmbcrun
