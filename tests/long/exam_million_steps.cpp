// SPDX-License-Identifier: MIT
/// A certificate is a promise for any number of steps: every one of the committed tables, run for a
/// million.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nmbc/certificate.hpp>
#include <nmbc/chain.hpp>
#include <nmbc/ends.hpp>
#include <nmbc/energy.hpp>
#include <nmbc/lattice.hpp>
#include <nmbc/tables/tables.hpp>
#include <optional>
#include <random>
#include <vector>

namespace {

using nmbc::MatchingTable;
using nmbc::Window;

/// Displacements and velocities of all nodes: some of every wave.
void randomise(nmbc::Chain& chain) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (auto values : {chain.displacement(), chain.velocity()}) {
        std::ranges::generate(values, [&] { return normal(random); });
    }
}

/// Just below the largest certified one, or the one that the table is matched in; none where that
/// is longer.
std::optional<double> time_step_of(const MatchingTable& table, double G) {
    try {
        return (table.time_step == "0" ? 0.95 : 1) * nmbc::stable_time_step(table, G, 1, 1);
    } catch (const nmbc::NotCertified&) {
        REQUIRE(table.time_step != "0");
        return std::nullopt;
    }
}

void check_million_steps(const MatchingTable& table, double G, std::size_t nodes,
                         double time_step) {
    CAPTURE(table.name);
    CAPTURE(G);
    CAPTURE(nodes);
    const auto lattice = nmbc::make_lattice(table, G);
    nmbc::Chain chain(lattice, nmbc::MatchingEnd{nmbc::boundary_coefficients(table, G)},
                      {.nodes = nodes, .time_step = time_step});
    randomise(chain);
    const auto run = [&chain](int steps) {
        for (int i = 0; i < steps; ++i) {
            chain.step();
        }
        return nmbc::energies(chain).total();
    };
    const double start = run(1);
    const double half_way = run(500000);
    const double end = run(500000);
    CHECK(chain.is_finite());
    CHECK(end < start);
    // What grows slowly from a small share would pass the line above, not this one. Two waves that
    // decay slowly beat, so that their energy swings, by a factor of 1.5 at most was seen; what
    // roundings keep alive is 1e-27 of the start.
    CHECK(end < 2 * half_way + 1e-24 * start);
}

/// The shortest certified ones, of both parities: an instability may need one of them.
std::array<std::size_t, 2> lengths(const MatchingTable& table) {
    const auto least = static_cast<std::size_t>(table.least_nodes);
    return {least, least + 1};
}

/// Where in a window. Damped chains are longer and slower: the middle only.
std::vector<double> shares(const MatchingTable& table) {
    return table.lattice->tau != "0" ? std::vector{0.5} : std::vector{0.25, 0.5, 0.75};
}

TEST_CASE("a million steps in every window") {
    for (const MatchingTable* table : nmbc::generated::tables) {
        int runs = 0;
        for (const Window& window : table->modal) {
            const double high = std::isinf(window.high) ? window.low + 4 : window.high;
            for (const double share : shares(*table)) {
                const double G = window.low + share * (high - window.low);
                const auto time_step = time_step_of(*table, G);
                for (const std::size_t nodes : lengths(*table)) {
                    if (time_step) {
                        check_million_steps(*table, G, nodes, *time_step);
                        ++runs;
                    }
                }
            }
        }
        CHECK_MESSAGE((runs > 0 || table->modal.empty()), table->name);
    }
}

}  // namespace
