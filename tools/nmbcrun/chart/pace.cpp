// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/chart/pace.hpp"

#include <cstddef>
#include <nmbc/chain.hpp>
#include <nmbc/ends.hpp>

#include "tools/nmbcrun/chart/long_run.hpp"
#include "tools/nmbcrun/chart/trial.hpp"
#include "tools/nmbcrun/output/processor_clock.hpp"

namespace nmbcrun {

Pace pace_of(const Scene& scene) {
    nmbc::Chain bare = chain_between(scene, nmbc::IdleEnd{}, nmbc::IdleEnd{});
    constexpr std::size_t node_steps = 2'000'000;  // some milliseconds
    const std::size_t looks = 1 + node_steps / (steps_between_looks * scene.nodes);
    const auto timed = [&](const auto& advance) {
        const double start = seconds_of_this_thread();
        for (std::size_t look = 0; look < looks; ++look) {
            advance();
        }
        return (seconds_of_this_thread() - start) /
               (double(looks * steps_between_looks) * double(scene.nodes));
    };
    const auto step_by_step = [&] {
        for (std::size_t step = 0; step < steps_between_looks; ++step) {
            bare.step();
        }
    };
    volatile double seen = 0;  // else the look is optimised away
    const auto looked_at = [&] {
        bare.advance(steps_between_looks);
        seen = largest_displacement(bare);
    };
    timed(step_by_step);  // to warm up
    return {.step_by_step = timed(step_by_step), .long_run = timed(looked_at)};
}

}  // namespace nmbcrun
