// SPDX-License-Identifier: MIT
// A plane with forces on velocities: waves against their own steps, energy against what is taken.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nmbc/plane.hpp>
#include <nmbc/plane_stability.hpp>
#include <numbers>
#include <stdexcept>

#include "tests/runtime/plane_bodies.hpp"

using namespace nmbc;

namespace {

constexpr double tau = 0.1;

CorrespondenceModel damped(unsigned radius_squared, double G) {
    return nopd2d(radius_squared, 0.25, G, StressState::plane_stress, tau);
}

/// tau sigma of waves xi: what the stabilisation at G = pi adds to omega^2, times tau.
double damping_at(const CorrespondenceModel& model, const std::array<double, 2>& xi) {
    CorrespondenceModel stabilised = nopd2d(model.radius_squared, 0.25, std::numbers::pi);
    CorrespondenceModel bare = nopd2d(model.radius_squared, 0.25, 0);
    stabilised.influence = bare.influence = model.influence;
    return tau * (plane_wave(stabilised, xi, true).omega_squared -
                  plane_wave(bare, xi, true).omega_squared);
}

}  // namespace

TEST_CASE("waves of a damped plane go as the polynomial of their step says") {
    constexpr std::size_t n = 16;
    const std::array<double, 2> xi{2 * std::numbers::pi * 2 / n, 2 * std::numbers::pi * 5 / n};
    for (const CorrespondenceModel& model :
         {damped(1, 0.5), damped(4, 0.5), damped(9, 0.5), damped(10, 0.5),
          with_influence(damped(4, 0.5), {5, 2, 1})}) {
        CAPTURE(model.radius_squared);
        PlaneParameters p{.nx = n, .ny = n, .spacing = 0.5, .youngs_modulus = 7, .density = 3};
        constexpr double dt = 0.3;
        p.time_step = dt / p.rate();
        Plane plane(model, PlaneSides::all(PeriodicSide{}), p);
        const PlaneWave wave = plane_wave(model, xi, true);
        for (std::size_t y = 0; y < n; ++y) {
            for (std::size_t x = 0; x < n; ++x) {
                for (const std::size_t a : {0U, 1U}) {
                    plane.velocity(a)[plane.entry(x, y)] =
                        p.rate() * wave.direction[a] *
                        std::cos(xi[0] * double(x) + xi[1] * double(y));
                }
            }
        }
        plane.start();
        // In units of the wave: v at -dt/2, then v+ = v - dt omega^2 u - dt tau sigma v, u+ = u +
        // dt v+.
        const double sigma = damping_at(model, xi);
        REQUIRE(sigma > 0.01);
        double u = 0;
        double v = 1 + dt / 2 * sigma;
        constexpr int steps = 40;
        for (int step = 0; step < steps; ++step) {
            v -= dt * (wave.omega_squared * u + sigma * v);
            u += dt * v;
        }
        plane.advance(steps);
        for (const std::size_t a : {0U, 1U}) {
            CHECK(plane.displacement(a)[plane.entry(0, 0)] ==
                  doctest::Approx(wave.direction[a] * u).epsilon(1000 * eps).scale(1));
        }
    }
}

TEST_CASE("the ledger of a damped plane closes, and steps up to the longest one lose energy" *
          doctest::test_suite("long")) {
    const PlaneSide periodic = PeriodicSide{};
    const PlaneSide passive = some_passive_side(0);
    for (const PlaneSides& sides :
         {PlaneSides::all(FixedSide{}), PlaneSides::all(FreeSide{}), PlaneSides::all(passive),
          PlaneSides{periodic, periodic, passive, FixedSide{}}}) {
        for (const unsigned radius_squared : {1U, 9U}) {
            CAPTURE(radius_squared);
            const CorrespondenceModel model = damped(radius_squared, 0.25);
            PlaneParameters p{.nx = 14, .ny = 11, .spacing = 2, .youngs_modulus = 5, .density = 3};
            p.time_step = 0.999 * longest_step(model, sides, p.nx, p.ny) / p.rate();
            CHECK(p.time_step * p.rate() < 2 / std::sqrt(highest_eigenvalue(model)));
            Plane plane(model, sides, p);
            fill_at_random(plane, 5);
            plane.start();
            CHECK(plane.damped() == 0);
            const double first = plane.energies().staggered;
            plane.advance(10);
            const PlaneState<double> state = plane.state();
            plane.advance(1000);
            const double last = plane.energies().staggered;
            CHECK(std::isfinite(last));
            CHECK(plane.damped() > 0.01 * first);
            // Sums over some hundred nodes round by some eps in each step.
            CHECK(std::abs(last + plane.damped() + sum_of(plane.left()) - first) <
                  10 * 1000 * eps * first);

            Plane again(model, sides, p);
            again.resume(state);
            again.advance(1000);
            CHECK(again.damped() == plane.damped());
            CHECK(std::ranges::equal(again.displacement(1), plane.displacement(1)));
        }
    }
}

TEST_CASE("a tau that is none is refused") {
    for (const double bad : {-0.1, std::nan(""), HUGE_VAL}) {
        CHECK_THROWS_AS(nopd2d(1, 0.25, 0, StressState::plane_stress, bad), std::invalid_argument);
    }
}
