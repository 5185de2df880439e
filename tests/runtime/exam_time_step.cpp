// SPDX-License-Identifier: MIT
/// Boundaries that are matched in leapfrog steps: found, refused in other steps, and what they are
/// for.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nmbc/boundary.hpp>
#include <nmbc/chain.hpp>
#include <nmbc/ends.hpp>
#include <nmbc/tables/tables.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

constexpr double matched_G = 0.5;
constexpr const nmbc::MatchingTable& matched = nmbc::generated::nopd1d_n1_order2_dt1o2;
constexpr const nmbc::MatchingTable& continuous = nmbc::generated::nopd1d_n1_order2;

nmbc::Chain chain_of(const nmbc::MatchingTable& table, const nmbc::ChainParameters& parameters,
                     nmbc::GhostRule rule = nmbc::GhostRule::midpoint) {
    return {nmbc::make_lattice(table, matched_G),
            nmbc::MatchingEnd{nmbc::boundary_coefficients(table, matched_G), rule}, parameters};
}

/// The largest displacement left of a pulse of half-width 6 dX when it should be gone.
double left_behind(const nmbc::MatchingTable& table) {
    constexpr std::size_t nodes = 200;
    nmbc::Chain chain = chain_of(table, {.nodes = nodes, .time_step = 0.5});
    std::vector<double> u(chain.nodes());
    for (std::size_t i = 0; i < u.size(); ++i) {
        const double x = (static_cast<double>(i) - static_cast<double>(u.size() - 1) / 2) / 6;
        u[i] = std::exp(-x * x);
    }
    chain.start(u, std::vector<double>(u.size()));
    while (chain.time() < 250) {
        chain.step();
    }
    double most = 0;
    for (const double value : chain.displacement()) {
        most = std::max(most, std::abs(value));
    }
    return most;
}

}  // namespace

TEST_CASE("a table matched in time steps is found by its step only") {
    const auto& all = nmbc::generated::tables;
    CHECK(nmbc::find_table(all, "nopd1d", 1, 2) == &continuous);
    CHECK(nmbc::find_table(all, "nopd1d", 1, 2, 1, "0", "1/2") == &matched);
    CHECK(nmbc::find_table(all, "nopd1d", 1, 2, 1, "0", "1/7") == nullptr);
    CHECK(nmbc::boundary_coefficients(matched, matched_G).matched_time_step == 0.5);
    CHECK(nmbc::boundary_coefficients(continuous, matched_G).matched_time_step == 0);
}

TEST_CASE("it takes its own time step only, in any units, and midpoint ghosts") {
    CHECK_NOTHROW(chain_of(matched, {.nodes = 20, .time_step = 0.5}));
    // c = 2, dX = 1/10: dt = 0.5 dX/c = 0.025; seven digits will do.
    CHECK_NOTHROW(chain_of(
        matched, {.nodes = 20, .spacing = 0.1, .youngs_modulus = 4, .time_step = 0.02500001}));
    for (const double other : {0.4, 0.49, 0.50001, 0.6}) {
        CHECK_THROWS_WITH_AS(chain_of(matched, {.nodes = 20, .time_step = other}),
                             doctest::Contains("matched in time steps of 0.5 dX/c, not "),
                             std::invalid_argument);
        CHECK_NOTHROW(chain_of(continuous, {.nodes = 20, .time_step = other}));
    }
    CHECK_THROWS_WITH_AS(
        chain_of(matched, {.nodes = 20, .time_step = 0.5}, nmbc::GhostRule::explicit_rule),
        doctest::Contains("midpoint ghosts"), std::invalid_argument);
}

TEST_CASE("its stable time step is its own, where that is certified") {
    CHECK(nmbc::stable_time_step(matched, matched_G, 1, 1) == 0.5);
    CHECK(nmbc::stable_time_step(matched, matched_G, 4, 0.2) ==
          doctest::Approx(0.025).epsilon(1e-15));
    // n = 2, N = 3, s = 2 is certified to cfl 0.27 at G = 2, and steps of 1 dX/c are cfl 0.625.
    CHECK_THROWS_WITH_AS(
        nmbc::stable_time_step(nmbc::generated::nopd1d_n2_order3_s2_dt1o1, 2, 1, 1),
        doctest::Contains("is certified for no time step at G = 2"), nmbc::NotCertified);
    CHECK_THROWS_AS(nmbc::boundary_coefficients(nmbc::generated::nopd1d_n2_order3_s2_dt1o1, 2),
                    nmbc::NotCertified);
}

TEST_CASE("a chain takes a certified boundary of its own lattice only") {
    const auto coefficients = nmbc::boundary_coefficients(continuous, matched_G);
    const nmbc::ChainParameters parameters{.nodes = 20, .time_step = 0.4};
    CHECK_NOTHROW(nmbc::Chain(nmbc::make_lattice(continuous, matched_G),
                              nmbc::MatchingEnd{coefficients}, parameters));
    for (const auto& [table, other_G] :
         {std::pair(&continuous, 0.4), {&nmbc::generated::nopd1d_n2_order1, matched_G}}) {
        CHECK_THROWS_WITH_AS(nmbc::Chain(nmbc::make_lattice(*table, other_G),
                                         nmbc::MatchingEnd{coefficients}, parameters),
                             doctest::Contains("certified for another lattice"),
                             nmbc::NotCertified);
        CHECK_NOTHROW(nmbc::Chain(nmbc::make_lattice(*table, other_G),
                                  nmbc::MatchingEnd{nmbc::boundary_coefficients(
                                      continuous, matched_G, nmbc::allow_unstable)},
                                  parameters));
    }
}

TEST_CASE("in its steps less of a pulse is left behind") {
    // Measured: 4.0e-4 and 9.3e-6.
    const double before = left_behind(continuous);
    const double now = left_behind(matched);
    CHECK(before > 3e-4);
    CHECK(now < 1e-5);
}
