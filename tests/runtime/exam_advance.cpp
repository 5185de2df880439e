// SPDX-License-Identifier: GPL-2.0-or-later
/// Many steps at once are the steps one by one, bit for bit, whatever loop does them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>

#include "tests/runtime/random_start.hpp"

namespace {

constexpr double G_of_advance = 0.9;

const nmbc::MatchingTable& table_of(int horizon) {
    const auto* table = nmbc::find_table(nmbc::generated::tables, "nopd1d", horizon, 1);
    REQUIRE(table != nullptr);
    return *table;
}

/// omega^2 = 2 sum k_m (1 - cos m xi) of springs k_m = 1/m^3, and a damping a tenth of it.
nmbc::Lattice springs(std::size_t reach, bool damped) {
    nmbc::Lattice lattice;
    lattice.symbol.assign(reach + 1, 0.0);
    for (std::size_t m = 1; m <= reach; ++m) {
        lattice.symbol[m] = -std::pow(double(m), -3);
        lattice.symbol[0] -= 2 * lattice.symbol[m];
    }
    if (damped) {
        lattice.damping = lattice.symbol;
        for (double& entry : lattice.damping) {
            entry /= 10;
        }
    }
    return lattice;
}

template <class Real>
void check_same(const nmbc::BasicChain<Real>& one, const nmbc::BasicChain<Real>& other) {
    CHECK(one.is_finite());
    CHECK(one.steps() == other.steps());
    CHECK(std::ranges::equal(one.displacement(), other.displacement()));
    CHECK(std::ranges::equal(one.velocity(), other.velocity()));
    CHECK(std::ranges::equal(one.damped(), other.damped()));
}

TEST_CASE_TEMPLATE("advance is so many steps, bit for bit", Real, double, float) {
    using End = nmbc::BasicChainEnd<Real>;
    const nmbc::MatchingEnd matching{
        nmbc::boundary_coefficients(table_of(1), G_of_advance, nmbc::allow_unstable)};
    // Some blocks, with a rest; less than one; and one node.
    for (const std::size_t nodes : {1111U, 61U, 1U}) {
        for (const bool damped : {false, true}) {
            for (const std::size_t reach : {1U, 2U, 3U, 6U, 10U, 12U, 13U, 20U}) {
                for (const auto& [left, right] :
                     {std::pair(End(matching), End(nmbc::FixedEnd{5})),
                      std::pair(End(nmbc::FixedEnd{}), End(matching)),
                      std::pair(End(nmbc::FreeEnd{}), End(nmbc::FreeEnd{}))}) {
                    const nmbc::ChainParameters parameters{
                        .nodes = std::max(nodes, reach), .spacing = 0.7, .time_step = 0.1};
                    CAPTURE(parameters.nodes);
                    CAPTURE(damped);
                    CAPTURE(reach);
                    nmbc::BasicChain<Real> at_once(springs(reach, damped), left, right, parameters);
                    nmbc::BasicChain<Real> one_by_one(springs(reach, damped), left, right,
                                                      parameters);
                    start_at_random(at_once);
                    start_at_random(one_by_one);
                    at_once.advance(0);
                    at_once.advance(17);
                    for (int step = 0; step < 17; ++step) {
                        one_by_one.step();
                    }
                    check_same(at_once, one_by_one);
                }
            }
        }
    }
}

TEST_CASE("between two sweeps the hooks see and do the same") {
    for (const bool damped : {false, true}) {
        const nmbc::ChainParameters parameters{.nodes = 700, .time_step = 0.1};
        nmbc::Chain at_once(springs(4, damped), nmbc::FreeEnd{}, parameters);
        nmbc::Chain one_by_one(springs(4, damped), nmbc::FreeEnd{}, parameters);
        start_at_random(at_once);
        start_at_random(one_by_one);
        const auto prescribe = [](std::span<const double> u, std::span<double> v, double time) {
            v[300] = std::sin(time) - u[300];
        };
        const auto seen = [](std::vector<double>& into) {
            return [&into](std::span<const double> u, std::span<const double> v, double time) {
                into.insert(into.end(), {time, u[3], u[300], v[0], v[300], v[302]});
            };
        };
        std::vector<double> by_advance;
        std::vector<double> by_steps;
        at_once.advance(20, prescribe, seen(by_advance));
        for (int step = 0; step < 20; ++step) {
            one_by_one.step(prescribe, seen(by_steps));
        }
        CHECK(by_advance.size() == 120);
        CHECK(by_advance == by_steps);
        check_same(at_once, one_by_one);
    }
}

TEST_CASE("fields written to in a hook are a new start to the ends, at once") {
    const nmbc::ChainParameters parameters{.nodes = 20, .time_step = 0.1};
    nmbc::Chain chain(springs(2, false), nmbc::FixedEnd{}, parameters);
    start_at_random(chain);
    chain.advance(3, [&chain](auto&&, auto&&, double) { chain.displacement()[0] = 1; });
    CHECK(chain.displacement()[0] == 1);  // since the last step; the two before were held at 0
    chain.advance(1);
    CHECK(chain.displacement()[0] == 0);
}

TEST_CASE_TEMPLATE("rest stays rest, wherever it is", Real, double, float) {
    // No constant here is a sum of few powers of 2, and float has its own ones.
    for (int horizon = 1; horizon <= 5; ++horizon) {
        nmbc::BasicChain<Real> chain(nmbc::make_lattice(table_of(horizon), double(Real(0.7))),
                                     nmbc::FreeEnd{},
                                     {.nodes = 50, .spacing = 0.3, .time_step = 0.1});
        const std::vector<Real> u(chain.nodes(), 3);
        chain.start(u, std::vector<Real>(chain.nodes()));
        chain.advance(10000);
        // What is left is omega^2(0), a rounding error eps' of the table's doubles, whatever Real
        // is: u grows by at most (rate t)^2/2 eps' = (1000/0.3)^2/2 eps'; eps' is of a few terms
        // below 10.
        for (const Real displacement : chain.displacement()) {
            CHECK(displacement == doctest::Approx(3).scale(0).epsilon(5.6e6 * 2e-15));
        }
    }
}

TEST_CASE("a lattice that holds its nodes in place") {
    // omega^2 = 4 + 2 (1 - cos xi): nodes that move alike swing at omega = 2.
    nmbc::Lattice lattice;
    lattice.symbol = {6, -1};
    constexpr double dt = 0.05;
    nmbc::Chain chain(lattice, nmbc::FreeEnd{}, {.nodes = 10, .time_step = dt});
    chain.start(std::vector<double>(chain.nodes(), 1), std::vector<double>(chain.nodes(), 0));
    chain.advance(100);
    // Leapfrog: sin(omega' dt/2) = omega dt/2, at rest at t = 0.
    const double omega = 2 / dt * std::asin(dt);
    // 100 steps of some 10 roundings.
    CHECK(chain.displacement()[5] == doctest::Approx(std::cos(omega * 5)).scale(1).epsilon(1e-13));
}

}  // namespace
