// SPDX-License-Identifier: GPL-2.0-or-later
/// The chain: leapfrog, energies, driving, errors.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>
#include <numbers>

#include "tests/runtime/random_start.hpp"

namespace {

nmbc::Chain chain_of(int horizon, int order, double G, const nmbc::ChainParameters& parameters) {
    const auto* table = nmbc::find_table(nmbc::generated::tables, "nopd1d", horizon, order);
    REQUIRE(table != nullptr);
    return {nmbc::make_lattice(*table, G),
            nmbc::MatchingEnd{nmbc::boundary_coefficients(*table, G, nmbc::allow_unstable)},
            parameters};
}

/// Starts the chain from a Gaussian displacement in its middle, at rest.
void start_gaussian(nmbc::Chain& chain, double half_width) {
    std::vector<double> u(chain.nodes());
    const std::vector<double> v(chain.nodes(), 0.0);
    for (std::size_t i = 0; i < u.size(); ++i) {
        const double x = (double(i) - double(u.size() - 1) / 2) / half_width;
        u[i] = std::exp(-x * x);
    }
    chain.start(u, v);
}

TEST_CASE("leapfrog keeps the staggered energy until a wave reaches an end") {
    for (int horizon = 1; horizon <= 5; ++horizon) {
        CAPTURE(horizon);
        auto chain = chain_of(
            horizon, 1, 0.9,
            {.nodes = 600, .spacing = 0.5, .youngs_modulus = 3, .density = 2, .time_step = 0.1});
        start_gaussian(chain, 8);
        chain.step();
        const double first = nmbc::energies(chain).staggered;
        double highest_total = 0;
        for (int i = 0; i < 800; ++i) {  // n = 5 has waves faster than c; at 900 they arrive
            chain.step();
            highest_total = std::max(highest_total, nmbc::energies(chain).total());
        }
        // 800 steps of 600 nodes: roundings add up as sqrt(5e5) eps = 1.6e-13
        CHECK(nmbc::energies(chain).staggered == doctest::Approx(first).scale(0).epsilon(2e-13));
        // total - staggered is a sum of squares, (dt/2)^2 times the strain energy of the velocity:
        // (omega dt)^2/4 of a wave's potential energy, with omega < 0.5 and dt = 0.1.
        CHECK(highest_total > first);
        CHECK(highest_total < first * (1 + 6.3e-4));
    }
}

TEST_CASE("energies are the sums of the lattice's squares") {
    const auto check = [](const nmbc::Lattice& lattice) {
        constexpr double dt = 0.01;
        nmbc::Chain chain(lattice, nmbc::FixedEnd{},
                          {.nodes = 150, .spacing = 0.5, .youngs_modulus = 3, .time_step = dt});
        start_at_random(chain);
        double strain = 0;
        double stabilisation = 0;
        double staggered = 0;
        for (std::size_t node = 0; node < 150; ++node) {
            const double v = chain.velocity()[chain.first_interior() + node];
            staggered += 0.5 * v * v / 2;
            for (const auto& [part, weight, stencil] : chain.lattice().energy) {
                const std::size_t first = chain.first_interior() + node - stencil.size() / 2;
                const double now = nmbc::detail::apply(stencil, &chain.displacement()[first]);
                const double rate = nmbc::detail::apply(stencil, &chain.velocity()[first]);
                const double middle = now - dt / 2 * rate;  // E/dX = 6
                (part == nmbc::EnergyPart::strain ? strain : stabilisation) +=
                    6 * weight * middle * middle / 2;
                staggered += 6 * weight * now * (now - dt * rate) / 2;
            }
        }
        // Some hundred terms, each of a few roundings.
        constexpr double roundings = 1e-14;
        const auto e = nmbc::energies(chain);
        CHECK(std::abs(e.strain - strain) <= roundings * strain);
        CHECK(std::abs(e.stabilisation - stabilisation) <= roundings * stabilisation);
        CHECK(std::abs(e.staggered - staggered) <= roundings * staggered);
    };
    for (const nmbc::LatticeTable* const table : nmbc::generated::lattices) {
        CAPTURE(table->name);
        check(nmbc::make_lattice(*table, 0));
        check(nmbc::make_lattice(*table, 0.7));
    }
    // By hand: mirror images, of which one is negative; none; multiples; weights below 0.
    using enum nmbc::EnergyPart;
    nmbc::Lattice lattice = nmbc::make_lattice(nmbc::generated::nopd1d_n2, 0);
    lattice.energy = {{strain, 2, {0, 0, 1, -2, 0.5}},     {strain, 2, {-0.5, 2, -1, 0, 0}},
                      {strain, 3, {0, 1, 0.25, 0, 0}},     {stabilisation, 1, {1, 0, 3, 0, 1}},
                      {stabilisation, 4, {2, 0, 6, 0, 2}}, {strain, -0.1, {0, -1, 0, 1, 0}}};
    check(lattice);
}

TEST_CASE("energies of a plane wave") {
    // u = cos(xi x - omega t): kinetic and potential energy per node are omega^2/4 each, here
    // through the discrete relation sin(omega dt/2) = (dt/2) omega_lattice.
    constexpr double dt = 0.05;
    constexpr int nodes = 60;
    constexpr double xi = 2 * std::numbers::pi / 20;  // 3 wavelengths on 60 nodes
    auto chain = chain_of(2, 1, 0.5, {.nodes = nodes, .time_step = dt});
    const double lattice_omega = std::sqrt(nmbc::omega_squared(chain.lattice(), xi));
    const double omega = 2 / dt * std::asin(dt * lattice_omega / 2);
    for (std::size_t i = 0; i < chain.nodes(); ++i) {
        const double phase = xi * double(i);
        chain.displacement()[i] = std::cos(phase);
        chain.velocity()[i] = (std::cos(phase) - std::cos(phase + omega * dt)) / dt;
    }
    const auto e = nmbc::energies(chain);
    CHECK(e.kinetic == doctest::Approx(nodes * lattice_omega * lattice_omega / 4).epsilon(1e-13));
    // <u^k, K u^{k+1}> = omega_l^2 cos(omega dt) /2 on average, kinetic as above; together
    // omega_l^2/4 (1 + cos(omega dt)) per node.
    const double staggered = nodes * lattice_omega * lattice_omega / 4 * (1 + std::cos(omega * dt));
    CHECK(e.staggered == doctest::Approx(staggered).epsilon(1e-13));
    CHECK(e.strain > 0);
    CHECK(e.stabilisation > 0);
    // Half of the chain holds half of the energy: 30 nodes are one and a half wavelengths.
    CHECK(nmbc::energies(chain, 0, 30).kinetic == doctest::Approx(e.kinetic / 2).epsilon(1e-13));
}

TEST_CASE("start moves the velocity back by half a step") {
    auto chain = chain_of(1, 1, 0, {.nodes = 20, .time_step = 0.1});
    std::vector<double> u(chain.nodes());
    const std::vector<double> v(chain.nodes(), 3.0);
    u[12] = 1;
    chain.start(u, v);
    // (22): a = (u_{I-2} - 2 u_I + u_{I+2})/4
    CHECK(chain.velocity()[12] == doctest::Approx(3 + 0.05 * 0.5).epsilon(1e-15));
    CHECK(chain.velocity()[10] == doctest::Approx(3 - 0.05 * 0.25).epsilon(1e-15));
    CHECK(chain.velocity()[11] == 3);
    CHECK_THROWS_AS(chain.start(u, std::vector<double>(3)), std::invalid_argument);
}

TEST_CASE("prescribed velocities move their nodes and nothing else at once") {
    auto chain = chain_of(1, 1, 0.5, {.nodes = 30, .time_step = 0.1});
    chain.step([&chain](std::span<const double> u, std::span<double> v, double time) {
        CHECK(time == doctest::Approx(0.1));
        v[15] = (0.25 - u[15]) / chain.parameters().time_step;
    });
    CHECK(chain.displacement()[15] == doctest::Approx(0.25).epsilon(1e-15));
    CHECK(chain.displacement()[14] == 0);
    CHECK(chain.steps() == 1);
}

TEST_CASE("a Gaussian pulse leaves; higher orders leave less of it") {
    // n = 1, G = 1/2 is the atom chain: omega = 2 sin(xi/2), and NMBC1 reflects
    // |R| = |omega - 2 tan(xi/2)| / (omega + 2 tan(xi/2)) = tan^2(xi/4), nearly xi^2/16. A Gaussian
    // of half-width 10 has energy xi^2 exp(-50 xi^2) at xi, so sigma^2 = 1/100 and the energy left
    // after one reflection is <xi^6>/<xi^2>/256 = 15 sigma^4/256 = 5.86e-6.
    std::vector<double> left;
    for (int order = 1; order <= 3; ++order) {
        auto chain = chain_of(1, order, 0.5, {.nodes = 300, .time_step = 0.05});
        start_gaussian(chain, 10);
        chain.step();
        const double first = nmbc::energies(chain).total();
        while (chain.time() < 250) {
            chain.step();
        }
        left.push_back(nmbc::energies(chain).total() / first);
    }
    // The next term of tan^2(xi/4), and the time step, are of relative order sigma^2 = 1 %.
    CHECK(left[0] == doctest::Approx(5.86e-6).scale(0).epsilon(0.02));
    // R of order N is O(xi^2N), its energy O(sigma^4N): 1e-4 between orders but for constants of
    // order 100; orders 3 and 4 are at the error of the time step, dt^2/24 in R.
    CHECK(left[1] < 1e-3 * left[0]);
    CHECK(left[2] < left[1]);
}

TEST_CASE("not finite is found, with the node") {
    auto chain = chain_of(1, 1, 0, {.nodes = 20, .time_step = 0.1});
    CHECK(chain.is_finite());
    chain.velocity()[7] = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(chain.is_finite());
    CHECK(chain.first_not_finite() == 7);
}

TEST_CASE("wrong parameters are refused") {
    CHECK_THROWS_AS(chain_of(1, 1, 0, {.nodes = 0, .time_step = 0.1}), std::invalid_argument);
    CHECK_THROWS_AS(chain_of(1, 1, 0, {.nodes = 10, .time_step = 0}), std::invalid_argument);
    CHECK_THROWS_AS(chain_of(1, 1, 0, {.nodes = 10, .youngs_modulus = -1, .time_step = 0.1}),
                    std::invalid_argument);
    CHECK_THROWS_AS(
        chain_of(1, 1, 0, {.nodes = 10, .youngs_modulus = -1, .density = -1, .time_step = 0.1}),
        std::invalid_argument);
    CHECK_THROWS_AS(chain_of(1, 4, 0.5, {.nodes = 3, .time_step = 0.1}), std::invalid_argument);
    CHECK_NOTHROW(chain_of(1, 4, 0.5, {.nodes = 4, .time_step = 0.1}));
    const auto chain = chain_of(1, 1, 0, {.nodes = 10, .time_step = 0.1});
    CHECK_THROWS_AS(nmbc::energies(chain, 5, 5), std::invalid_argument);
    CHECK_THROWS_AS(nmbc::energies(chain, 0, 11), std::invalid_argument);
}

}  // namespace
