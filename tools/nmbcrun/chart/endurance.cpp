// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/chart/endurance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nmbc/chain.hpp>
#include <nmbc/energy.hpp>
#include <random>
#include <span>

#include "tools/nmbcrun/chart/chains.hpp"
#include "tools/nmbcrun/simulation/ends.hpp"

namespace nmbcrun {
namespace {

void start_randomly(nmbc::Chain& chain) {
    std::mt19937_64 random(20180417);
    std::normal_distribution<double> normal;
    std::vector<double> u(chain.nodes());
    // The standard deviation of displacements is 1; at rest, so that nothing moves as a whole, and
    // still next to the ends, where an exact one wants it to be.
    const auto inside = std::span(u)
                            .subspan(chain.first_interior(), chain.parameters().nodes)
                            .subspan(2 * chain.ghosts());
    std::ranges::generate(inside.first(inside.size() - 2 * chain.ghosts()),
                          [&] { return normal(random); });
    chain.start(u, std::vector<double>(u.size()));
}

double largest_displacement(const nmbc::Chain& chain) {
    double largest = 0;
    for (const double u : chain.displacement()) {
        largest = std::isfinite(u) ? std::max(largest, std::abs(u))
                                   : std::numeric_limits<double>::infinity();
    }
    return largest;
}

}  // namespace

std::string_view name_of(Fate fate) {
    switch (fate) {
        case Fate::drifts:
            return "drifts";
        case Fate::unstable:
            return "unstable";
        case Fate::steady:
            break;
    }
    return "steady";
}

Endurance endure(Scene scene, std::size_t steps) {
    scene.end = double(steps) * scene.step.value();
    nmbc::Chain chain =
        chain_between(scene, chain_end(scene, scene.left), chain_end(scene, scene.right));
    start_randomly(chain);
    const double energy = nmbc::energies(chain).staggered;
    // A quarter, a half and the whole: a power of time doubles its logarithm's step once more, an
    // exponential function squares it.
    std::array<double, 3> largest{};
    std::size_t i = 0;
    constexpr std::size_t look_every = 1000;
    constexpr double beyond = 1e12;  // of the start: no power of time in 1e7 steps
    while (chain.steps() < steps) {
        chain.step();
        for (const std::size_t part : {4U, 2U, 1U}) {
            if (chain.steps() == steps / part && i < largest.size()) {
                largest[i++] = largest_displacement(chain);
            }
        }
        if (chain.steps() % look_every == 0 && !(largest_displacement(chain) < beyond)) {
            const double rate = std::log(largest_displacement(chain)) / chain.time();
            return {Fate::unstable, std::numeric_limits<double>::infinity(), rate};
        }
    }
    const double early = std::log(largest[1] / largest[0]);
    const double late = std::log(largest[2] / largest[1]);
    Endurance result{.energy = nmbc::energies(chain).staggered / energy};
    // What keeps its energy varies by a fifth or so; t^(1/2) grows by 0.35 from half to whole.
    constexpr double grows = 0.3;
    if (late > grows && early > grows) {
        const bool exponential = late > 1.5 * early;
        result.fate = exponential ? Fate::unstable : Fate::drifts;
        result.rate = exponential ? late / (chain.time() / 2) : late / std::log(2);
    }
    return result;
}

}  // namespace nmbcrun
