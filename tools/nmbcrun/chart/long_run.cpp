// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/chart/long_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nmbc/chain.hpp>
#include <random>
#include <span>

#include "tools/nmbcrun/simulation/ends.hpp"

namespace nmbcrun {
namespace {

void start_randomly(nmbc::Chain& chain) {
    std::mt19937_64 random(20180417);
    std::normal_distribution<double> normal;
    std::vector<double> u(chain.nodes());
    // The standard deviation of displacements is 1; at rest, so that nothing moves as a whole, and
    // still next to the ends, where an exact one wants it to be, and no other one minds.
    const std::size_t nodes = chain.parameters().nodes;
    const std::size_t still = std::min(2 * chain.ghosts(), (nodes - 1) / 2);
    std::ranges::generate(std::span(u).subspan(chain.first_interior() + still, nodes - 2 * still),
                          [&] { return normal(random); });
    chain.start(u, std::vector<double>(u.size()));
}

}  // namespace

double largest_displacement(const nmbc::Chain& chain) {
    double largest = 0;
    for (const double u : chain.displacement()) {
        largest = std::isfinite(u) ? std::max(largest, std::abs(u))
                                   : std::numeric_limits<double>::infinity();
    }
    return largest;
}

std::string_view name_of(LongRun outcome) {
    switch (outcome) {
        case LongRun::drifts:
            return "drifts";
        case LongRun::unstable:
            return "unstable";
        case LongRun::grows:
            return "grows";
        case LongRun::steady:
            break;
    }
    return "steady";
}

LongTimeStability stability_shown_by(const std::vector<double>& largest, double time) {
    std::array<double, 3> octaves{};  // the largest from 1/8 to 1/4 of the time, .. 1/2 to all
    for (std::size_t i = 0; i < octaves.size(); ++i) {
        const std::size_t last = (largest.size() - 1) >> (octaves.size() - 1 - i);
        octaves[i] = *std::max_element(largest.begin() + std::ptrdiff_t(last / 2),
                                       largest.begin() + std::ptrdiff_t(last + 1));
    }
    const double early = std::log(octaves[1] / octaves[0]);
    const double late = std::log(octaves[2] / octaves[1]);
    // In an octave t^(1/2) grows by 0.35, and what keeps its energy by a third now and then, but
    // not twice; what grows at last, when all else has decayed, by more.
    constexpr double grows = 0.3;
    constexpr double turns = 1;
    if (late < (early > grows ? grows : turns)) {
        return {};
    }
    const double exponent = late / (time / 2);
    // On top of what is there from the start, powers up to t^3 differ enough from exp(t) from here
    // on.
    constexpr double clear = 100;
    if (octaves[2] < clear * *std::ranges::min_element(largest)) {
        return {LongRun::grows, exponent};
    }
    // A power of time has the same in every octave, an exponential function the double.
    const bool exponential = late > 1.5 * early;
    return exponential ? LongTimeStability{LongRun::unstable, exponent}
                       : LongTimeStability{LongRun::drifts, late / std::log(2)};
}

LongTimeStability long_time_stability(const Scene& scene, std::size_t steps,
                                      const Advance& advance) {
    nmbc::Chain chain =
        chain_between(scene, chain_end(scene, scene.left), chain_end(scene, scene.right));
    start_randomly(chain);
    constexpr double beyond = 1e100;  // of the start: no power of time comes so far, nor back
    std::vector<double> largest{largest_displacement(chain)};
    const auto skip_rest = [&] { advance(1 - double(chain.steps()) / double(steps)); };
    while (chain.steps() < steps) {
        const std::size_t some = std::min(steps_between_looks, steps - chain.steps());
        chain.advance(some);
        advance(double(some) / double(steps));
        largest.push_back(largest_displacement(chain));
        if (!(largest.back() < beyond)) {
            skip_rest();
            const std::size_t later = largest.size() / 2;
            const double looks = double(later) / double(largest.size() - 1);
            return {LongRun::unstable,
                    std::log(largest.back() / largest[largest.size() - 1 - later]) /
                        (looks * chain.time())};
        }
        if (largest.back() < 1 / beyond) {
            skip_rest();
            return {};
        }
    }
    return stability_shown_by(largest, chain.time());
}

}  // namespace nmbcrun
