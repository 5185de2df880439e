// SPDX-License-Identifier: MIT
// A plane lattice between its sides: energy against what leaves through them, and how it is run.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nmbc/plane.hpp>
#include <nmbc/plane_stability.hpp>
#include <stdexcept>
#include <vector>

#include "tests/runtime/plane_bodies.hpp"

using namespace nmbc;

namespace {

/// That a body's energy falls by what leaves through its sides, to the roundings of the steps.
void check_balance(const PlaneModel& model, const PlaneSides& sides, const PlaneParameters& body,
                   int steps) {
    Plane plane(model, sides, body);
    fill_at_random(plane, 7);
    plane.start();
    plane.advance(1);
    const double at_first = plane.energies().staggered;
    const double before = at_first + sum_of(plane.left());
    plane.advance(std::size_t(steps));
    const double after = plane.energies().staggered;
    CHECK(after < at_first);
    CHECK(after + sum_of(plane.left()) == doctest::Approx(before).epsilon(steps * eps));
}

}  // namespace

TEST_CASE("what leaves through passive sides is what a body loses, to rounding") {
    for (const unsigned radius_squared : {1U, 2U, 4U, 5U, 8U, 9U}) {
        const PlaneModel model = nopd2d(radius_squared, 0.25, 1);
        const PassiveSide passive = some_passive_side(0.3);
        const PassiveSide without = some_passive_side(0);
        for (const PlaneSides& sides :
             {PlaneSides::all(passive), PlaneSides{without, FreeSide{}, without, FreeSide{}},
              PlaneSides{FixedSide{}, passive, passive, FixedSide{}},
              PlaneSides{PeriodicSide{}, PeriodicSide{}, passive, FixedSide{}},
              PlaneSides{passive, SpongeSide{{0.3, 0.2, 0.1}}, passive, SpongeSide{{0.4, 0.1}}},
              PlaneSides{passive, SpongeSide{{0.3, 0.2, 0.1}}, FixedSide{}, passive}}) {
            CAPTURE(radius_squared);
            CAPTURE(sides.right.index());
            check_balance(model, sides, body_parameters(13, 15, model), 300);
        }
    }
}

TEST_CASE("what leaves is what a body loses, where sweeps take several blocks and many lines") {
    for (const unsigned radius_squared : {1U, 4U, 9U}) {
        const PlaneModel model = nopd2d(radius_squared, 0.25, 1);
        const PassiveSide passive = some_passive_side(0);
        for (const PlaneSides& sides :
             {PlaneSides::all(passive), PlaneSides{passive, FreeSide{}, MirrorSide{}, passive},
              PlaneSides{FixedSide{}, passive, passive, FreeSide{}}}) {
            CAPTURE(radius_squared);
            CAPTURE(sides.left.index());
            check_balance(model, sides, body_parameters(140, 70, model), 30);
        }
    }
}

TEST_CASE("sides that take nothing keep the energy; a free body at rest may move and turn") {
    const PlaneModel model = nopd2d(5, 0.3, 0.5, StressState::plane_strain);
    for (const PlaneSides& sides :
         {PlaneSides::all(FreeSide{}), PlaneSides::all(FixedSide{}),
          PlaneSides{PeriodicSide{}, PeriodicSide{}, FreeSide{}, FixedSide{}},
          PlaneSides::all(PeriodicSide{})}) {
        Plane plane(model, sides, body_parameters(12, 11, model));
        fill_at_random(plane, 3);
        plane.start();
        const double before = plane.energies().staggered;
        plane.advance(500);
        CHECK(plane.energies().staggered == doctest::Approx(before).epsilon(500 * eps));
        CHECK(plane.left() == std::array<double, 4>{});
    }
    Plane body(model, PlaneSides::all(FreeSide{}), body_parameters(12, 11, model));
    for (std::size_t y = 0; y < 11; ++y) {
        for (std::size_t x = 0; x < 12; ++x) {
            body.displacement(0)[body.entry(x, y)] = 1 - 0.01 * double(y);
            body.displacement(1)[body.entry(x, y)] = 2 + 0.01 * double(x);
        }
    }
    body.start();
    body.advance(100);
    for (const double v : body.velocity(0)) {
        CHECK(std::abs(v) < 1000 * eps);
    }
    CHECK(body.energies().strain + body.energies().stabilisation < 1000 * eps * eps * 121);
}

TEST_CASE("bodies thinner than a horizon keep their energy, whichever side is free") {
    const PlaneModel model = nopd2d(9, 0.25, 1);
    for (const std::size_t nx : {1U, 2U}) {
        for (const bool is_left_free : {true, false}) {
            const PlaneSide free = FreeSide{};
            const PlaneSide fixed = FixedSide{};
            Plane plane(model,
                        {is_left_free ? free : fixed, is_left_free ? fixed : free, fixed, fixed},
                        body_parameters(nx, 20, model, 0.2));
            fill_at_random(plane, 4);
            plane.start();
            const double before = plane.energies().staggered;
            plane.advance(500);
            CHECK(plane.energies().staggered == doctest::Approx(before).epsilon(500 * eps));
        }
    }
}

TEST_CASE("a plane in floats does what one in doubles does, to the rounding of floats") {
    const PlaneModel model = nopd2d(4, 0.25, 1);
    const PlaneSides sides = PlaneSides::all(some_passive_side(0.2));
    Plane in_doubles(model, sides, body_parameters(20, 30, model));
    BasicPlane<float> in_floats(model, sides, body_parameters(20, 30, model));
    fill_at_random(in_doubles, 11);
    for (const std::size_t a : {0U, 1U}) {
        std::ranges::transform(in_doubles.displacement(a), in_floats.displacement(a).begin(),
                               [](double value) { return static_cast<float>(value); });
        std::ranges::transform(in_doubles.velocity(a), in_floats.velocity(a).begin(),
                               [](double value) { return static_cast<float>(value); });
    }
    in_doubles.start();
    in_floats.start();
    in_doubles.advance(50);
    in_floats.advance(50);
    for (const std::size_t a : {0U, 1U}) {
        for (std::size_t i = 0; i < in_doubles.displacement(a).size(); ++i) {
            // 50 steps of some roundings of 6e-8; measured 2e-6.
            CHECK(std::abs(in_floats.displacement(a)[i] - float(in_doubles.displacement(a)[i])) <
                  1e-5F);
        }
    }
}

TEST_CASE("a hook before the sides may prescribe velocities, and one after the step sees it") {
    const PlaneModel model = nopd2d(1, 0.25, 0.2);
    Plane plane(model, PlaneSides::all(some_passive_side(0)), body_parameters(6, 6, model));
    std::size_t seen = 0;
    plane.advance(
        3, [](Plane& body, double time) { body.velocity(1)[body.entry(2, 3)] = time; },
        [&](const Plane& body) {
            ++seen;
            CHECK(body.steps() == seen);
            CHECK(body.velocity(1)[body.entry(2, 3)] == doctest::Approx(body.time()));
        });
    CHECK(seen == 3);
}

TEST_CASE("a plane that goes on from a state does so bit for bit") {
    const PlaneModel model = nopd2d(4, 0.25, 1);
    const HigdonSide higdon{{model.speed_P(), model.speed_S()}, 0.002};
    const PlaneSides sides{some_passive_side(0.2), higdon, PeriodicSide{}, PeriodicSide{}};
    Plane plane(model, sides, body_parameters(12, 10, model));
    Plane other(model, sides, body_parameters(12, 10, model));
    fill_at_random(plane, 1);
    fill_at_random(other, 2);
    plane.start();
    other.start();
    plane.advance(20);
    other.advance(7);
    other.resume(plane.state());
    plane.advance(20);
    other.advance(20);
    CHECK(other.steps() == plane.steps());
    CHECK(other.left() == plane.left());
    for (const std::size_t a : {0U, 1U}) {
        CHECK(std::ranges::equal(plane.displacement(a), other.displacement(a)));
        CHECK(std::ranges::equal(plane.velocity(a), other.velocity(a)));
    }
    Plane larger(model, sides, body_parameters(13, 10, model));
    CHECK_THROWS_AS(larger.resume(plane.state()), std::invalid_argument);
}

TEST_CASE("a longest step is that of the body with its sides" * doctest::test_suite("long")) {
    const PassiveSide passive = some_passive_side(0);
    const PlaneSide free = FreeSide{};
    const PlaneSide periodic = PeriodicSide{};
    const auto check = [](const PlaneModel& model, const PlaneSides& sides, std::size_t nx,
                          std::size_t ny) {
        const double longest = 2 / std::sqrt(highest_eigenvalue(model, sides, nx, ny));
        for (const bool is_below : {true, false}) {
            Plane plane(model, sides,
                        {.nx = nx, .ny = ny, .time_step = longest * (is_below ? 0.999 : 1.02)});
            fill_at_random(plane, 9);
            plane.start();
            plane.advance(1000);
            CAPTURE(nx);
            CAPTURE(is_below);
            CHECK((plane.energies().kinetic < 1e3) == is_below);
        }
    };
    for (const unsigned radius_squared : {1U, 4U, 9U}) {
        CAPTURE(radius_squared);
        const PlaneModel model = nopd2d(radius_squared, 0.25, 0.5);
        CHECK(highest_eigenvalue(model, PlaneSides::all(FixedSide{}), 99, 99) ==
              doctest::Approx(1.01 * highest_eigenvalue(model)));  // 1 % is added
        check(model, PlaneSides::all(passive), 12, 12);
        check(model, {periodic, periodic, free, free}, 30, 12);
        check(model, {periodic, periodic, passive, free}, 12, 9);
        check(model, {free, passive, FixedSide{}, free}, 12, 30);
        check(model, PlaneSides::all(free), 2 * model.horizon(), 30);
        check(model, PlaneSides::all(free), 3 * model.horizon(), 3 * model.horizon());
    }
}
