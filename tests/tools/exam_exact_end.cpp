// SPDX-License-Identifier: GPL-2.0-or-later
/// A chain with exact ends, and what they refuse.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

#include "tests/tools/exact_cases.hpp"
#include "tools/nmbcrun/ends/exact.hpp"
#include "tools/nmbcrun/ends/transparent_kernel.hpp"

namespace {

/// Nothing near the ends, and every wave number in the middle. Of the same interior with any layer.
void start_randomly(nmbc::Chain& chain) {
    std::mt19937_64 random(20180417);
    std::normal_distribution<double> normal;
    std::vector<double> u(chain.nodes());
    std::vector<double> v(chain.nodes());
    const std::size_t nodes = chain.parameters().nodes;
    const double unit = chain.parameters().wave_speed() / chain.parameters().spacing;
    for (std::size_t node = nodes / 3; node < nodes * 2 / 3; ++node) {
        u[chain.first_interior() + node] = normal(random);
        v[chain.first_interior() + node] = normal(random) * unit;
    }
    chain.start(u, v);
}

double largest(std::span<const double> values) {
    const auto [low, high] = std::ranges::minmax(values);
    return std::max(-low, high);
}

std::span<const double> interior(const nmbc::Chain& chain) {
    return chain.displacement().subspan(chain.first_interior(), chain.parameters().nodes);
}

/// The largest difference of the two interiors' u in that many steps, over the largest u.
double difference(nmbc::Chain& one, nmbc::Chain& other, std::size_t steps) {
    start_randomly(one);
    start_randomly(other);
    double error = 0;
    double scale = 0;
    for (std::size_t k = 0; k < steps; ++k) {
        one.step();
        other.step();
        scale = std::max(scale, largest(interior(other)));
        for (std::size_t node = 0; node < one.parameters().nodes; ++node) {
            error = std::max(error, std::abs(interior(one)[node] - interior(other)[node]));
        }
    }
    return error / scale;
}

nmbc::ChainParameters parameters_of(const nmbc::Lattice& lattice, double cfl,
                                    std::size_t nodes = 40) {
    nmbc::ChainParameters p{.nodes = nodes, .spacing = 0.5, .youngs_modulus = 3, .density = 2};
    p.time_step = courant_of(lattice, cfl) * p.spacing / p.wave_speed();
    return p;
}

/// A step changes dt v by up to 4 cfl^2 u and rounds that, and a wave that stands still is carried
/// on by each such rounding to the end of the run: steps^(3/2) of them where they are random.
double roundings_of(double cfl, std::size_t steps) {
    return std::pow(double(steps), 1.5) * 4 * cfl * cfl * std::numeric_limits<double>::epsilon();
}

TEST_CASE("a chain between exact ends is one that nothing returns in") {
    constexpr std::size_t steps = 300;
    const nmbc::ChainEnd exact = nmbcrun::ExactEnd{steps};
    const nmbc::ChainEnd free_end = nmbc::FreeEnd{};
    for (const Case& one : cases({1, 2, 3}, {0.0, 0.3, 1.0}, {0.3, 0.95})) {
        const auto lattice = lattice_of(one.horizon, one.G, one.tau);
        // A step reaches r nodes further: these are out of reach there and back.
        const nmbc::ChainEnd wide = nmbc::FixedEnd{lattice.reach() * steps / 2};
        const auto p = parameters_of(lattice, one.cfl);
        for (const int free_side : {0, 1, 2}) {  // none, left, right
            nmbc::Chain shorter(lattice, free_side == 1 ? free_end : exact,
                                free_side == 2 ? free_end : exact, p);
            nmbc::Chain longer(lattice, free_side == 1 ? free_end : wide,
                               free_side == 2 ? free_end : wide, p);
            CAPTURE(one);
            CAPTURE(free_side);
            CHECK(difference(shorter, longer, steps) < roundings_of(one.cfl, steps));
        }
    }
}

TEST_CASE("opposite a matching boundary, too") {
    constexpr std::size_t steps = 300;
    const auto& table = *nmbc::find_table(nmbc::generated::tables, "nopd1d", 1, 2);
    const auto lattice = nmbc::make_lattice(table, 0.5);
    const nmbc::ChainEnd matching =
        nmbc::MatchingEnd{nmbc::boundary_coefficients(table, 0.5, nmbc::Opposite::any)};
    const auto p = parameters_of(lattice, 0.5);
    nmbc::Chain one(lattice, matching, nmbcrun::ExactEnd{steps}, p);
    nmbc::Chain other(lattice, matching, nmbc::FixedEnd{lattice.reach() * steps / 2}, p);
    CHECK(difference(one, other, steps) < 2e-13);  // as above
}

TEST_CASE("a stored run goes on bit for bit") {
    constexpr std::size_t steps = 300;
    for (const double tau : {0.0, 0.05}) {
        const auto lattice = lattice_of(2, 0.3, tau);
        const auto p = parameters_of(lattice, 0.5);
        const auto new_chain = [&] { return nmbc::Chain(lattice, nmbcrun::ExactEnd{steps}, p); };
        const auto finish = [](nmbc::Chain& chain) {
            while (chain.steps() < steps) {
                chain.step();
            }
            return chain.state();
        };
        auto straight = new_chain();
        start_randomly(straight);
        std::vector<nmbc::ChainState<double>> stored;
        for (const std::size_t steps_before : {0U, 1U, 100U, 128U, 199U, 300U}) {
            while (straight.steps() < steps_before) {
                straight.step();
            }
            stored.push_back(straight.state());
        }
        const auto expected = finish(straight);
        for (const auto& state : stored) {
            auto resumed = new_chain();
            resumed.resume(state);
            const auto found = finish(resumed);
            CAPTURE(state.steps);
            CHECK(found.displacement == expected.displacement);
            CHECK(found.velocity == expected.velocity);
            CHECK(found.left == expected.left);
            CHECK(found.right == expected.right);
        }
        nmbc::Chain shorter(lattice, nmbcrun::ExactEnd{steps - 1}, p);
        CHECK_THROWS_AS(shorter.resume(stored[2]), std::invalid_argument);
    }
}

TEST_CASE("a second start forgets the first run") {
    constexpr std::size_t steps = 100;
    const auto lattice = lattice_of(1, 1);
    const auto p = parameters_of(lattice, 0.9);
    nmbc::Chain chain(lattice, nmbcrun::ExactEnd{steps}, p);
    const auto run = [&] {
        start_randomly(chain);
        while (chain.steps() < steps) {
            chain.step();
        }
        return std::vector(chain.displacement().begin(), chain.displacement().end());
    };
    const auto first = run();
    CHECK(run() == first);
}

TEST_CASE("what starts near an exact end is refused") {
    const auto lattice = lattice_of(2, 1);  // reaches 4 nodes
    const auto p = parameters_of(lattice, 0.5);
    nmbc::Chain chain(lattice, nmbcrun::ExactEnd{10}, p);
    const auto starts = [&](std::size_t node, double u_there, double v_there) {
        std::vector<double> u(chain.nodes(), 0.0);
        std::vector<double> v(chain.nodes(), 0.0);
        u[chain.nodes() / 2] = 1;
        u[node] = u_there;
        v[node] = v_there;
        chain.start(u, v);
    };
    const std::size_t last = chain.nodes() - 1;
    for (const std::size_t node :
         {std::size_t(0), std::size_t(3), std::size_t(7), last - 7, last}) {
        CHECK_THROWS_WITH_AS(starts(node, 1e-11, 0),
                             doctest::Contains("an exact end starts from rest"),
                             std::invalid_argument);
        CHECK_THROWS_AS(starts(node, 0, 1e-10), std::invalid_argument);
        CHECK_NOTHROW(starts(node, 1e-13, 0));
    }
    CHECK_NOTHROW(starts(12, 1, 1));
    // Written to once waves are at the end.
    start_randomly(chain);
    for (int i = 0; i < 9; ++i) {
        chain.step();
    }
    chain.displacement()[20] = 3;
    CHECK_THROWS_AS(chain.step(), std::invalid_argument);
}

TEST_CASE("an exact end that cannot be") {
    const auto lattice = lattice_of(2, 1);
    const auto p = parameters_of(lattice, 0.5);
    const auto made = [&](std::size_t steps, const nmbc::ChainParameters& parameters) {
        return nmbc::Chain(lattice, nmbcrun::ExactEnd{steps}, parameters);
    };
    CHECK_THROWS_WITH_AS(made(0, p), doctest::Contains("1 to 200000 steps, not 0"),
                         std::invalid_argument);
    CHECK_THROWS_AS(made(nmbcrun::ExactEnd::most_steps + 1, p), std::invalid_argument);
    CHECK_THROWS_WITH_AS(made(10, parameters_of(lattice, 1.01)),
                         doctest::Contains("that the interior is stable in"),
                         std::invalid_argument);
    CHECK_NOTHROW(made(10, parameters_of(lattice, 1)));
    CHECK_THROWS_WITH_AS(made(10, parameters_of(lattice, 0.5, 3)),
                         doctest::Contains("at least 4 interior nodes"), std::invalid_argument);
    CHECK_NOTHROW(made(10, parameters_of(lattice, 0.5, 4)));
    nmbc::Lattice wrong = lattice;
    wrong.damping.assign(lattice.symbol.size() + 1, 0.0);
    CHECK_THROWS_AS(nmbcrun::transparent_kernel(wrong, 0.1, 10), std::invalid_argument);
    CHECK_THROWS_AS(nmbcrun::transparent_kernel(lattice, std::nan(""), 10), std::invalid_argument);

    auto chain = made(3, p);
    for (int i = 0; i < 3; ++i) {
        chain.step();
    }
    CHECK_THROWS_WITH_AS(chain.step(), doctest::Contains("made for 3 steps"), std::length_error);
}

}  // namespace
