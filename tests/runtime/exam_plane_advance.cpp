// SPDX-License-Identifier: MIT
// Drift and kick in one sweep over a plane: whatever its sides are, many steps at once are steps
// one by one.
#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <nmbc/plane.hpp>
#include <nmbc/plane_stability.hpp>
#include <vector>

#include "tests/runtime/plane_bodies.hpp"

using namespace nmbc;

namespace {

std::vector<PlaneSides> some_sides(const PlaneModel& model) {
    const PassiveSide passive = some_passive_side(0);
    const SpongeSide sponge{{0.3, 0.2, 0.1}};
    const HigdonSide higdon{{model.speed_P(), 0.6 * model.speed_P()}, 0.002};
    return {PlaneSides::all(FixedSide{}),
            PlaneSides::all(FreeSide{}),
            PlaneSides::all(passive),
            PlaneSides::all(PeriodicSide{}),
            PlaneSides::all(higdon),
            PlaneSides{PeriodicSide{}, PeriodicSide{}, passive, sponge},
            PlaneSides{FreeSide{}, sponge, PeriodicSide{}, PeriodicSide{}},
            PlaneSides{PeriodicSide{}, PeriodicSide{}, higdon, FixedSide{}},
            PlaneSides{higdon, FixedSide{}, PeriodicSide{}, PeriodicSide{}}};
}

/// Nine steps from a random start. prepare(plane) comes before it.
template <class Real, class Prepare>
void require_alike(const PlaneModel& model, const PlaneSides& sides, const PlaneParameters& p,
                   const Prepare& prepare) {
    BasicPlane<Real> at_once(model, sides, p);
    BasicPlane<Real> one_by_one(model, sides, p);
    for (BasicPlane<Real>* plane : {&at_once, &one_by_one}) {
        prepare(*plane);
        fill_at_random(*plane, 1);
        plane->start();
    }
    at_once.advance(9);
    for (int i = 0; i < 9; ++i) {
        one_by_one.advance(1);
    }
    const auto expected = one_by_one.state();
    const auto found = at_once.state();
    CHECK(found.displacement == expected.displacement);
    CHECK(found.velocity == expected.velocity);
    CHECK(found.ghosts == expected.ghosts);
    CHECK(found.bonds == expected.bonds);
    CHECK(found.broken == expected.broken);
    CHECK(found.released == expected.released);
    CHECK(at_once.left() == one_by_one.left());
    CHECK(at_once.steps() == 9);
}

}  // namespace

TEST_CASE_TEMPLATE("many steps of a plane at once are steps one by one", Real, double, float) {
    for (const unsigned radius_squared : {1U, 2U, 4U, 5U, 8U, 9U, 10U}) {
        const PlaneModel model = nopd2d(radius_squared, 0.25, 0.5);
        const double step = 0.5 / std::sqrt(highest_eigenvalue(model));
        for (const PlaneSides& sides : some_sides(model)) {
            for (const std::size_t ny :
                 {7U, 12U, 31U}) {  // rows too few for one sweep, just enough
                CAPTURE(radius_squared);
                CAPTURE(sides.left.index());
                CAPTURE(sides.bottom.index());
                CAPTURE(ny);
                require_alike<Real>(model, sides, {.nx = 150, .ny = ny, .time_step = step},
                                    [](const auto&) {});
            }
        }
    }
}

TEST_CASE_TEMPLATE("many steps of breaking bonds at once are steps one by one", Real, double,
                   float) {
    const MirrorSide mirror{};
    for (const unsigned radius_squared : {1U, 4U, 9U}) {
        const std::vector<double> weights(plane_bond_classes(radius_squared).size(), 0.5);
        const PlaneModel model = bond2d(radius_squared, weights);
        const double step = 0.5 / std::sqrt(highest_eigenvalue(model));
        std::vector<PlaneSides> all = some_sides(model);
        all.push_back(PlaneSides::all(mirror));
        all.push_back({mirror, FreeSide{}, PeriodicSide{}, PeriodicSide{}});
        all.push_back({FreeSide{}, some_passive_side(0), mirror, FixedSide{}});
        for (const PlaneSides& sides : all) {
            for (const std::size_t ny : {5U, 6U, 31U}) {
                CAPTURE(radius_squared);
                CAPTURE(sides.left.index());
                CAPTURE(sides.bottom.index());
                CAPTURE(ny);
                require_alike<Real>(
                    model, sides, {.nx = 300, .ny = ny, .time_step = step}, [](auto& plane) {
                        plane.break_above(1.5, [](auto x, auto /*y*/) { return x < 100; });
                    });
            }
        }
    }
}
