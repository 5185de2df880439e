// SPDX-License-Identifier: GPL-2.0-or-later
/// Higdon's product: order 1 is NMBC1, and the others' one-way equations hold at the ghosts.
#include <cmath>

#include "tests/nmbcrun/chains.hpp"
#include "tools/nmbcrun/ends/higdon.hpp"

namespace {

using nmbcrun::HigdonEnd;

TEST_CASE("order 1 is NMBC1 with midpoint ghosts") {
    for (int horizon = 1; horizon <= 4; ++horizon) {
        const nmbc::ChainParameters parameters{
            .nodes = 30, .spacing = 0.5, .youngs_modulus = 3, .density = 2, .time_step = 0.1};
        const auto coefficients =
            nmbc::boundary_coefficients(table_of(horizon), 0.9, nmbc::allow_unstable);
        CHECK(coefficients.b[1] == doctest::Approx(2));  // (58)
        nmbc::Chain higdon(lattice_of(horizon, 0.9), HigdonEnd{1}, parameters);
        nmbc::Chain matching(lattice_of(horizon, 0.9), nmbc::MatchingEnd{coefficients}, parameters);
        start_at_random(higdon);
        start_at_random(matching);
        for (int step = 0; step < 300; ++step) {
            higdon.step();
            matching.step();
        }
        for (std::size_t node = 0; node < higdon.nodes(); ++node) {
            // 300 steps of some 10 roundings of numbers of size 10, divided by dt = 0.1
            CHECK(std::abs(higdon.displacement()[node] - matching.displacement()[node]) < 1e-10);
        }
    }
}

/// One factor of the box scheme, of a field by level and node from the outermost ghost inwards.
using History = std::vector<std::vector<double>>;
History one_way(const History& u, double courant) {
    History result(u.size() - 1, std::vector<double>(u[0].size() - 1));
    for (std::size_t k = 0; k + 1 < u.size(); ++k) {
        for (std::size_t j = 0; j + 1 < u[0].size(); ++j) {
            const double in_time = (u[k + 1][j] + u[k + 1][j + 1] - u[k][j] - u[k][j + 1]) / 2;
            const double in_space = (u[k + 1][j + 1] - u[k + 1][j] + u[k][j + 1] - u[k][j]) / 2;
            result[k][j] = in_time - courant * in_space;
        }
    }
    return result;
}

/// u of 12 levels, from a random start, as the end sees it.
History levels_seen_by(nmbc::Chain& chain, bool on_the_left) {
    start_at_random(chain);
    History u;
    for (int level = 0; level < 12; ++level) {
        u.push_back(chain.state().displacement);  // to write to it would be a new start
        if (!on_the_left) {
            std::ranges::reverse(u.back());
        }
        chain.step();
    }
    return u;
}

TEST_CASE("the product vanishes at every ghost node") {
    for (int order = 1; order <= 4; ++order) {
        for (const bool on_the_left : {true, false}) {
            const nmbc::ChainEnd end = HigdonEnd{order};
            const nmbc::ChainEnd other = nmbc::FreeEnd{};
            nmbc::Chain chain(lattice_of(2, 1), on_the_left ? end : other,
                              on_the_left ? other : end, {.nodes = 20, .time_step = 0.3});
            History u = levels_seen_by(chain, on_the_left);
            const auto [least, most] = std::ranges::minmax(u.back());
            // 4^order terms of the largest u
            const double roundings = 1e-13 * std::pow(4, order) * std::max(-least, most);
            for (int factor = 0; factor < order; ++factor) {
                u = one_way(u, 0.3);
            }
            double largest = 0;
            for (const auto& level : u) {
                for (std::size_t ghost = 0; ghost < chain.ghosts(); ++ghost) {
                    largest = std::max(largest, std::abs(level[ghost]));
                }
            }
            CHECK(largest < roundings);
        }
    }
}

TEST_CASE("a rigid motion u = t goes on for ever from order 2 on, not at order 1") {
    for (int order = 1; order <= 3; ++order) {
        nmbc::Chain chain(lattice_of(1, 0.5), HigdonEnd{order}, {.nodes = 20, .time_step = 0.5});
        chain.start(std::vector<double>(chain.nodes()), std::vector<double>(chain.nodes(), 1.0));
        for (int step = 0; step < 400; ++step) {
            chain.step();
        }
        CAPTURE(order);
        const double middle = chain.velocity()[chain.nodes() / 2];
        if (order == 1) {
            CHECK(std::abs(middle) < 0.01);  // the slowest waves take their time: 0.0018
        } else {
            CHECK(std::abs(middle - 1) < 1e-9);  // roundings of u = 200, and the drift they make
        }
    }
}

TEST_CASE("orders that there are not") {
    const nmbc::ChainParameters parameters{.nodes = 20, .time_step = 0.1};
    for (const int order : {-1, 0, HigdonEnd::highest_order + 1}) {
        CHECK_THROWS_WITH_AS(nmbc::Chain(lattice_of(1, 1), HigdonEnd{order}, parameters),
                             doctest::Contains("is 1 to 10"), std::invalid_argument);
    }
    CHECK_THROWS_AS(nmbc::Chain(lattice_of(1, 1), HigdonEnd{4}, {.nodes = 3, .time_step = 0.1}),
                    std::invalid_argument);
}

}  // namespace
