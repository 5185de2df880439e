// SPDX-License-Identifier: GPL-2.0-or-later
/// A different end on each side of a chain: fixed, free, matching.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>
#include <random>

namespace {

constexpr double G_of_ends = 0.9;

const nmbc::MatchingTable& table_of(int horizon, int order, int stride = 1) {
    const auto* table = nmbc::find_table(nmbc::generated::tables, "nopd1d", horizon, order, stride);
    REQUIRE(table != nullptr);
    return *table;
}

nmbc::MatchingEnd matching(int horizon, int order, int stride = 1) {
    return {nmbc::boundary_coefficients(table_of(horizon, order, stride), G_of_ends,
                                        nmbc::allow_unstable)};
}

nmbc::Chain chain_between(int horizon, const nmbc::ChainEnd& left, const nmbc::ChainEnd& right,
                          const nmbc::ChainParameters& parameters) {
    return {nmbc::make_lattice(table_of(horizon, 1), G_of_ends), left, right, parameters};
}

/// Displacements and velocities on all nodes, ghosts included.
struct State {
    std::vector<double> u;
    std::vector<double> v;
};

State random_state(const nmbc::Chain& chain) {
    std::mt19937_64 random(20180417);
    std::normal_distribution<double> normal;
    State state{std::vector<double>(chain.nodes()), std::vector<double>(chain.nodes())};
    for (auto* values : {&state.u, &state.v}) {
        std::ranges::generate(*values, [&] { return normal(random); });
    }
    return state;
}

/// What leapfrog keeps where the interior's stiffness K is symmetric, per dX rho:
/// v.v/2 + u^k.K u^{k+1}/2, with K u = -a.
double leapfrog_energy(const nmbc::Chain& chain) {
    const auto& p = chain.parameters();
    std::vector<double> a(chain.nodes());
    const double rate = p.wave_speed() / p.spacing;
    nmbc::accelerations(chain.lattice(), rate * rate, chain.displacement(), a);
    double sum = 0;
    for (std::size_t i = chain.ghosts(); i + chain.ghosts() < chain.nodes(); ++i) {
        const double v = chain.velocity()[i];
        const double before = chain.displacement()[i] - p.time_step * v;
        sum += v * v / 2 - before * a[i] / 2;
    }
    return sum;
}

const nmbc::ChainEnd clamped = nmbc::FixedEnd{};
const nmbc::ChainEnd free_end = nmbc::FreeEnd{};

TEST_CASE("fixed and free ends keep the leapfrog energy") {
    for (int horizon = 1; horizon <= 5; ++horizon) {
        for (const auto& [left, right] :
             {std::pair(clamped, clamped), std::pair(free_end, free_end),
              std::pair(clamped, free_end)}) {
            auto chain = chain_between(
                horizon, left, right,
                {.nodes = 40, .spacing = 0.5, .youngs_modulus = 3, .density = 2, .time_step = 0.1});
            const State state = random_state(chain);  // its ghost entries are none of an end's
            chain.start(state.u, state.v);
            chain.step();
            const double first = leapfrog_energy(chain);
            for (int i = 0; i < 20000; ++i) {
                chain.step();
            }
            CAPTURE(horizon);
            // 20000 steps of 40 nodes and some 10 operations: roundings add up as
            // sqrt(8e6) eps = 6e-13, and a free chain drifts away by 2e4 widths of its waves.
            CHECK(leapfrog_energy(chain) == doctest::Approx(first).scale(0).epsilon(1e-11));
        }
    }
}

TEST_CASE("the staggered energy of the interior is kept between free ends") {
    // The lattice's squares are their own mirror images: those of the interior nodes are half of
    // those of the chain and its image.
    for (int horizon = 1; horizon <= 5; ++horizon) {
        auto chain = chain_between(horizon, free_end, free_end, {.nodes = 30, .time_step = 0.2});
        const State state = random_state(chain);
        chain.start(state.u, state.v);
        chain.step();
        const double first = nmbc::energies(chain).staggered;
        for (int i = 0; i < 1000; ++i) {
            chain.step();
        }
        CAPTURE(horizon);
        // 1000 steps of 30 nodes, as above: sqrt(3e5) eps = 1.2e-13
        CHECK(nmbc::energies(chain).staggered == doctest::Approx(first).scale(0).epsilon(2e-12));
    }
}

TEST_CASE("ghosts of fixed and free ends") {
    auto chain = chain_between(2, clamped, free_end, {.nodes = 20, .time_step = 0.1});
    const State state = random_state(chain);
    chain.start(state.u, state.v);
    for (int i = 0; i < 50; ++i) {
        chain.step();
    }
    const std::size_t last = chain.nodes() - 1;
    REQUIRE(chain.ghosts() == 4);
    for (const auto field : {chain.displacement(), chain.velocity()}) {
        for (std::size_t layer = 0; layer < chain.ghosts(); ++layer) {
            CHECK(field[layer] == 0);
            CHECK(field[last - layer] == field[last - (7 - layer)]);
        }
    }
}

TEST_CASE("a free end is the middle of a chain twice as long") {
    // Symmetric data between two like ends never leave their symmetry: the left half moves as a
    // chain with a free right end.
    const nmbc::ChainEnd end = matching(2, 1);
    auto half = chain_between(2, end, free_end, {.nodes = 25, .time_step = 0.3});
    auto whole = chain_between(2, end, end, {.nodes = 50, .time_step = 0.3});
    const State left = random_state(half);
    State both = random_state(whole);
    for (auto* field : {&both.u, &both.v}) {
        const auto& given = field == &both.u ? left.u : left.v;
        std::copy_n(given.begin(), 29, field->begin());
        std::reverse_copy(field->begin(), field->begin() + 29, field->begin() + 29);
    }
    half.start(left.u, left.v);
    whole.start(both.u, both.v);
    for (int i = 0; i < 500; ++i) {
        half.step();
        whole.step();
    }
    for (std::size_t node = 0; node < 29; ++node) {  // the same operations on the same numbers
        CHECK(half.displacement()[node] == whole.displacement()[node]);
    }
}

TEST_CASE("mirrored set-ups give mirrored results bit for bit") {
    const std::vector<nmbc::ChainEnd> ends{
        clamped, free_end, matching(2, 1), matching(2, 2, 2),
        nmbc::MatchingEnd{matching(2, 1).coefficients, nmbc::GhostRule::explicit_rule}};
    for (const auto& one : ends) {
        for (const auto& other : ends) {
            const nmbc::ChainParameters parameters{
                .nodes = 20, .youngs_modulus = 57.1464, .time_step = 0.02};
            auto chain = chain_between(2, one, other, parameters);
            auto mirrored = chain_between(2, other, one, parameters);
            State state = random_state(chain);
            chain.start(state.u, state.v);
            std::ranges::reverse(state.u);
            std::ranges::reverse(state.v);
            mirrored.start(state.u, state.v);
            for (int i = 0; i < 200; ++i) {
                chain.step();
                mirrored.step();
            }
            std::vector<double> back(mirrored.displacement().begin(),
                                     mirrored.displacement().end());
            std::ranges::reverse(back);
            CHECK(std::ranges::equal(chain.displacement(), back));
        }
    }
}

TEST_CASE("chains too short for their ends, and wrong parameters") {
    CHECK_THROWS_AS(chain_between(2, clamped, free_end, {.nodes = 3, .time_step = 0.1}),
                    std::invalid_argument);
    CHECK_NOTHROW(chain_between(2, clamped, free_end, {.nodes = 4, .time_step = 0.1}));
    CHECK_THROWS_AS(chain_between(2, clamped, clamped, {.nodes = 0, .time_step = 0.1}),
                    std::invalid_argument);
    CHECK_NOTHROW(chain_between(2, clamped, clamped, {.nodes = 1, .time_step = 0.1}));
    CHECK_THROWS_AS(chain_between(2, clamped, matching(2, 2, 2), {.nodes = 3, .time_step = 0.1}),
                    std::invalid_argument);
    CHECK_THROWS_AS(chain_between(2, clamped, clamped, {.nodes = 5, .time_step = 0}),
                    std::invalid_argument);
    CHECK_THROWS_AS(
        chain_between(2, clamped, clamped, {.nodes = 5, .spacing = -1, .time_step = 0.1}),
        std::invalid_argument);
}

}  // namespace
