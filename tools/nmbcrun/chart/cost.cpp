// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/chart/cost.hpp"

#include <algorithm>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <nmbc/chain.hpp>
#include <nmbc/ends.hpp>
#include <utility>

#include "tools/nmbcrun/chart/trial.hpp"
#include "tools/nmbcrun/output/processor_clock.hpp"
#include "tools/nmbcrun/scene/step_plan.hpp"
#include "tools/nmbcrun/simulation/ends.hpp"

namespace nmbcrun {
namespace {

using boost::math::statistics::median;

/// A field that is nowhere near the smallest doubles, which are slow, and 0 where an exact end
/// wants it to be.
void fill(nmbc::Chain& chain) {
    std::vector<double> u(chain.nodes());
    const std::size_t at_rest = 2 * chain.ghosts();
    for (std::size_t i = at_rest; i + at_rest < chain.parameters().nodes; ++i) {
        u[chain.first_interior() + i] = 2 + std::sin(0.1 * double(i));
    }
    chain.start(u, std::vector<double>(u.size()));
}

/// For each step of a run that begins here.
double seconds_per_step(nmbc::Chain& chain, std::size_t steps, const std::function<void()>& pause) {
    fill(chain);
    const double start = seconds_of_this_thread();
    constexpr std::size_t between = 100;  // pauses: a hundredth of a call for each step
    for (std::size_t step = 0; step < steps; ++step) {
        chain.step();
        if (step % between == between - 1) {
            pause();
        }
    }
    return (seconds_of_this_thread() - start) / double(steps);
}

nmbc::Chain chain_of(const Scene& scene) {
    return chain_between(scene, chain_end(scene, scene.left), chain_end(scene, scene.right));
}

/// A chain of the scene, and what its ends take to be made.
std::pair<nmbc::Chain, double> made(const Scene& scene, nmbc::Chain& bare, std::size_t burst,
                                    const std::function<void()>& pause) {
    std::vector<double> ratios;
    double spent = 0;
    while (true) {
        const double start = seconds_of_this_thread();
        { const nmbc::Chain without = chain_between(scene, nmbc::IdleEnd{}, nmbc::IdleEnd{}); }
        const double middle = seconds_of_this_thread();
        nmbc::Chain with = chain_of(scene);
        const double end = seconds_of_this_thread();
        ratios.push_back((end - middle - (middle - start)) / seconds_per_step(bare, burst, pause));
        pause();
        spent += end - middle;
        if (ratios.size() == making_rounds || spent > enough_timed) {
            return {std::move(with), median(ratios)};
        }
    }
}

}  // namespace

std::vector<RelativeCost> relative_costs(const std::vector<Scene>& scenes,
                                         const std::function<void()>& after_round,
                                         const std::function<void()>& pause, std::size_t rounds) {
    const auto burst =
        std::size_t(std::max(10.0, std::ceil(timing_burst / double(scenes.front().nodes))));
    nmbc::Chain bare = chain_between(scenes.front(), nmbc::IdleEnd{}, nmbc::IdleEnd{});
    std::vector<RelativeCost> costs;
    std::vector<nmbc::Chain> chains;
    costs.reserve(scenes.size());
    chains.reserve(scenes.size());
    for (const Scene& scene : scenes) {
        auto [chain, cost] = made(scene, bare, burst, pause);
        chains.push_back(std::move(chain));
        costs.push_back({.construction = cost});
    }
    // An exact end's steps take the longer, the more of them were before: it is timed through all.
    const auto steps_of = [burst](const Scene& scene) {
        const bool remembers =
            scene.left.kind == BoundaryKind::exact || scene.right.kind == BoundaryKind::exact;
        return remembers ? steps_until(scene.end, scene.step.value()) : burst;
    };
    std::vector<std::vector<double>> ratios(chains.size());
    std::vector<double> spent(chains.size());
    for (std::size_t round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < chains.size(); ++i) {
            if (spent[i] > enough_timed) {
                continue;
            }
            pause();
            const double before = seconds_per_step(bare, burst, pause);
            const double own = seconds_per_step(chains[i], steps_of(scenes[i]), pause);
            const double after = seconds_per_step(bare, burst, pause);
            ratios[i].push_back(2 * own / (before + after));
            spent[i] += own * double(steps_of(scenes[i]));
        }
        after_round();
    }
    for (std::size_t i = 0; i < chains.size(); ++i) {
        costs[i].step = median(ratios[i]);
    }
    return costs;
}

}  // namespace nmbcrun
