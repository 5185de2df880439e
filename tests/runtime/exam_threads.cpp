// SPDX-License-Identifier: GPL-2.0-or-later
/// With OpenMP, where threads share a sweep, every bit is as without.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>

#ifndef _OPENMP
#error "this test is about OpenMP"
#endif

namespace {

TEST_CASE_TEMPLATE("threads change no bit", Real, double, float) {
    for (int horizon = 1; horizon <= 3; ++horizon) {
        for (const std::size_t nodes : {1U, 30U, 1000U, 50000U}) {
            CAPTURE(horizon);
            CAPTURE(nodes);
            const auto* table = nmbc::find_table(nmbc::generated::tables, "nopd1d", horizon, 1);
            REQUIRE(table != nullptr);
            const auto run = [&](std::size_t threaded_nodes) {
                nmbc::detail::threaded_nodes = threaded_nodes;
                nmbc::BasicChain<Real> chain(nmbc::make_lattice(*table, 0.9), nmbc::FixedEnd{4},
                                             nmbc::FixedEnd{}, {.nodes = nodes, .time_step = 0.1});
                std::vector<Real> u(chain.nodes());
                for (std::size_t node = 0; node < u.size(); ++node) {
                    u[node] = static_cast<Real>(std::sin(double(node * node)));
                }
                chain.start(u, u);
                chain.advance(10);
                chain.step();
                return chain.state();
            };
            const auto threaded = run(0);
            const auto alone = run(std::numeric_limits<std::size_t>::max());
            CHECK(std::ranges::any_of(alone.displacement, [](Real u) { return u != 0; }));
            CHECK(threaded.displacement == alone.displacement);
            CHECK(threaded.velocity == alone.velocity);
        }
    }
}

}  // namespace
