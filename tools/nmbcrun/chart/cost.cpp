// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/chart/cost.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nmbc/chain.hpp>
#include <nmbc/ends.hpp>

#include "tools/nmbcrun/chart/chains.hpp"
#include "tools/nmbcrun/simulation/ends.hpp"

namespace nmbcrun {
namespace {

/// A field that is nowhere near the smallest doubles, which are slow, and 0 where an exact end
/// wants it to be. Too few steps follow for it to fade, or to grow beyond all doubles.
void fill(nmbc::Chain& chain) {
    std::vector<double> u(chain.nodes());
    const std::size_t at_rest = 2 * chain.ghosts();
    const std::size_t first = chain.first_interior() + at_rest;
    const std::size_t last = chain.first_interior() + chain.parameters().nodes - at_rest;
    for (std::size_t node = first; node < last; ++node) {
        u[node] = 2 + std::sin(0.1 * double(node));
    }
    chain.start(u, std::vector<double>(u.size()));
}

double seconds_of(nmbc::Chain& chain, std::size_t steps) {
    using Clock = std::chrono::steady_clock;
    fill(chain);
    const auto start = Clock::now();
    for (std::size_t step = 0; step < steps; ++step) {
        chain.step();
    }
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

}  // namespace

std::vector<double> relative_costs(const std::vector<Scene>& scenes,
                                   const std::function<void()>& after_round) {
    // A twentieth of a millisecond or so: mostly undisturbed where other programs run, too.
    constexpr double node_steps = 5e4;
    const auto steps =
        std::size_t(std::max(10.0, std::ceil(node_steps / double(scenes.front().nodes))));
    nmbc::Chain bare = chain_between(scenes.front(), nmbc::IdleEnd{}, nmbc::IdleEnd{});
    std::vector<nmbc::Chain> chains;
    chains.reserve(scenes.size());
    for (Scene scene : scenes) {
        scene.end = std::max(scene.end, double(steps) * scene.step.value());
        chains.push_back(
            chain_between(scene, chain_end(scene, scene.left), chain_end(scene, scene.right)));
    }
    std::vector<std::vector<double>> ratios(chains.size());
    for (std::size_t round = 0; round < cost_rounds; ++round) {
        for (std::size_t i = 0; i < chains.size(); ++i) {
            const double before = seconds_of(bare, steps);
            const double own = seconds_of(chains[i], steps);
            const double after = seconds_of(bare, steps);
            ratios[i].push_back(2 * own / (before + after));
        }
        after_round();
    }
    std::vector<double> costs;
    costs.reserve(ratios.size());
    for (const std::vector<double>& each : ratios) {
        costs.push_back(median(each));
    }
    return costs;
}

}  // namespace nmbcrun
