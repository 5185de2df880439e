// SPDX-License-Identifier: MIT
// A bond-based plane: forces against the energy of its bonds, waves against their dispersion,
// energy against what leaves and what breaks.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nmbc/plane.hpp>
#include <nmbc/plane_stability.hpp>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include "tests/runtime/plane_bodies.hpp"

using namespace nmbc;

namespace {

constexpr auto no_node = [](auto, auto) { return false; };  // no node is kept whole

/// Weights that differ, all above 0.
BondModel some_bonds(unsigned radius_squared) {
    std::vector<double> weights;
    for (const PlaneOffset& bond : plane_bond_classes(radius_squared)) {
        weights.push_back(1.0 / (3 * bond.x + bond.y));
    }
    return bond2d(radius_squared, weights);
}

PlaneParameters parameters(std::size_t nx, std::size_t ny, const PlaneModel& model,
                           const PlaneSides& sides) {
    PlaneParameters p{.nx = nx, .ny = ny, .spacing = 0.5, .youngs_modulus = 7, .density = 3};
    p.time_step = 0.9 * 2 / std::sqrt(highest_eigenvalue(model, sides, nx, ny)) / p.rate();
    return p;
}

}  // namespace

TEST_CASE("forces of a free rectangle are the gradient of the energy of its bonds") {
    constexpr int nx = 11;
    constexpr int ny = 9;
    for (const unsigned radius_squared : {1U, 2U, 4U, 5U, 8U, 9U, 16U, 25U}) {
        CAPTURE(radius_squared);
        const BondModel model = some_bonds(radius_squared);
        PlaneParameters p{.nx = nx, .ny = ny};
        p.time_step = 2;  // v is minus the acceleration then, after start()
        Plane plane(model, PlaneSides::all(FreeSide{}), p);
        fill_at_random(plane, radius_squared);
        for (const std::size_t a : {0U, 1U}) {
            std::ranges::fill(plane.velocity(a), 0.0);
        }
        plane.start();
        const auto entry = [&](int x, int y) {
            return plane.entry(std::size_t(x), std::size_t(y));
        };
        const auto force_on = [&](int x, int y) {
            std::array<double, 2> force{};
            for (const BondModel::Bond& bond : model.bonds()) {
                const PlaneOffset& R = bond.offset;
                if (x + R.x < 0 || x + R.x >= nx || y + R.y < 0 || y + R.y >= ny) {
                    continue;
                }
                const auto stretch = [&](std::size_t a) {
                    return plane.displacement(a)[entry(x + R.x, y + R.y)] -
                           plane.displacement(a)[entry(x, y)];
                };
                const double e = R.x * stretch(0) + R.y * stretch(1);
                force[0] += bond.weight * e * R.x;
                force[1] += bond.weight * e * R.y;
            }
            return force;
        };
        double largest = 0;
        for (int y = 0; y < ny; ++y) {
            for (int x = 0; x < nx; ++x) {
                const std::array<double, 2> force = force_on(x, y);
                largest = std::max({largest, std::abs(plane.velocity(0)[entry(x, y)] + force[0]),
                                    std::abs(plane.velocity(1)[entry(x, y)] + force[1])});
            }
        }
        CHECK(largest < 1000 * eps);  // sums of up to 80 forces of about 10
    }
}

TEST_CASE("bonds: what leaves through passive sides is what a body loses, to rounding") {
    for (const unsigned radius_squared : {1U, 2U, 4U, 9U}) {
        const BondModel model = some_bonds(radius_squared);
        const PassiveSide passive = some_passive_side(0);
        for (const PlaneSides& sides :
             {PlaneSides::all(passive), PlaneSides{passive, FreeSide{}, passive, FreeSide{}},
              PlaneSides{FixedSide{}, passive, passive, FixedSide{}},
              PlaneSides{PeriodicSide{}, PeriodicSide{}, passive, FixedSide{}},
              PlaneSides::all(FixedSide{}), PlaneSides::all(PeriodicSide{}),
              PlaneSides{passive, SpongeSide{{0.3, 0.2, 0.1}}, passive, SpongeSide{{0.4, 0.1}}}}) {
            CAPTURE(radius_squared);
            CAPTURE(sides.left.index());
            CAPTURE(sides.right.index());
            Plane plane(model, sides, parameters(13, 15, model, sides));
            fill_at_random(plane, 7);
            plane.start();
            const double at_first = plane.energies().staggered;
            plane.advance(300);
            const double after = plane.energies().staggered;
            CHECK(after <= at_first * (1 + 300 * eps));
            // The roundings of 300 steps.
            CHECK(after + sum_of(plane.left()) == doctest::Approx(at_first).epsilon(300 * eps));
        }
    }
}

TEST_CASE("bonds: plane waves of a periodic body have the frequencies of the lattice") {
    for (const unsigned radius_squared : {2U, 4U, 9U}) {
        const BondModel model = some_bonds(radius_squared);
        const PlaneSides sides = PlaneSides::all(PeriodicSide{});
        check_standing_waves(model, parameters(16, 16, model, sides));
    }
}

TEST_CASE("the energy of a body whose bonds break goes down by what these had, to rounding") {
    const BondModel model = some_bonds(9);
    const PassiveSide passive = some_passive_side(0);
    for (const PlaneSides& sides :
         {PlaneSides::all(FreeSide{}), PlaneSides::all(passive), PlaneSides::all(PeriodicSide{}),
          PlaneSides{FixedSide{}, passive, PeriodicSide{}, PeriodicSide{}}}) {
        CAPTURE(sides.right.index());
        Plane plane(model, sides, parameters(23, 25, model, sides));
        plane.cut({4, 12.5}, {15, 12.5});
        fill_at_random(plane, 5);
        plane.start();
        plane.break_above(1.6, no_node);
        const double at_first = plane.energies().staggered;
        plane.advance(300);
        CHECK(plane.broken() > 100);
        CHECK(plane.broken() < 23 * 25 * 14);
        CHECK(plane.released() > 0.01 * at_first);
        CHECK(plane.energies().staggered + plane.released() + sum_of(plane.left()) ==
              doctest::Approx(at_first).epsilon(3000 * eps));  // of 300 steps
    }
}

TEST_CASE("bonds that may break before the start break in the first step, and are counted there") {
    for (const unsigned radius_squared : {16U, 25U}) {  // of two words and of three
        const BondModel model = some_bonds(radius_squared);
        const PlaneSides sides{FixedSide{}, SpongeSide{{0.3, 0.1}}, FreeSide{}, FixedSide{}};
        const PlaneParameters p = parameters(18, 17, model, sides);
        Plane plane(model, sides, p);
        fill_at_random(plane, 8);
        plane.break_above(1, no_node);
        plane.start();
        CHECK(plane.broken() == 0);
        const double at_first = plane.energies().staggered;
        const PlaneState<double> state = plane.state();
        plane.advance(20);
        CHECK(plane.broken() > 100);
        CHECK(plane.energies().staggered + plane.released() + sum_of(plane.left()) ==
              doctest::Approx(at_first).epsilon(1000 * eps));
        Plane other(model, sides, p);
        other.break_above(1, no_node);
        other.resume(state);
        other.advance(20);
        CHECK(other.broken() == plane.broken());
        CHECK(other.released() == plane.released());
    }
}

TEST_CASE("bonds over the seam of periodic sides break as others do, unless their nodes are kept") {
    const BondModel model = some_bonds(4);
    const PlaneSides sides = PlaneSides::all(PeriodicSide{});
    Plane plane(model, sides, parameters(12, 12, model, sides));
    fill_at_random(plane, 6);
    plane.start();
    plane.break_above(1, [](std::ptrdiff_t x, std::ptrdiff_t /*y*/) { return x == 0; });
    const double at_first = plane.energies().staggered;
    plane.advance(30);
    for (std::size_t y = 0; y < 12; ++y) {
        CHECK(plane.damage(0, y) == 0);
    }
    // What no end decides alone: forces stay opposite, and the energy closes.
    CHECK(plane.energies().staggered + plane.released() ==
          doctest::Approx(at_first).epsilon(1000 * eps));
    Plane all(model, sides, plane.parameters());
    fill_at_random(all, 6);
    all.start();
    all.break_above(1, no_node);
    all.advance(30);
    double at_seam = 0;
    double inside = 0;
    for (std::size_t y = 0; y < 12; ++y) {
        at_seam += all.damage(0, y) / 12;
        inside += all.damage(6, y) / 12;
    }
    CHECK(at_seam > 0.2);
    CHECK(inside > 0.2);
}

TEST_CASE("what is symmetric stays so bit for bit while bonds break") {
    // Pulled up and down at random in x alone, with a cut from the left to the middle.
    const BondModel model = some_bonds(9);
    constexpr std::size_t nx = 41;
    constexpr std::size_t ny = 40;
    const PassiveSide passive = some_passive_side(0);
    for (const PlaneSides& sides :
         {PlaneSides::all(FreeSide{}), PlaneSides{FreeSide{}, passive, passive, passive}}) {
        Plane plane(model, sides, parameters(nx, ny, model, sides));
        plane.cut({-1, (ny - 1) / 2.0}, {20.3, (ny - 1) / 2.0});
        plane.break_above(0.02, no_node);
        std::mt19937 engine(3);
        std::uniform_real_distribution<double> uniform(0, 1);
        for (std::size_t x = 0; x < nx; ++x) {
            const double pull = uniform(engine);
            for (const std::size_t y : {std::size_t(0), ny - 1}) {
                plane.velocity(1)[plane.entry(x, y)] = y == 0 ? -pull : pull;
            }
        }
        plane.start();
        plane.advance(400);
        CHECK(plane.broken() > 50);
        for (std::size_t y = 0; y < ny; ++y) {
            for (std::size_t x = 0; x < nx; ++x) {
                const std::size_t here = plane.entry(x, y);
                const std::size_t there = plane.entry(x, ny - 1 - y);
                const bool is_alike =
                    plane.displacement(0)[here] == plane.displacement(0)[there] &&
                    plane.displacement(1)[here] == -plane.displacement(1)[there] &&
                    plane.damage(x, y) == plane.damage(x, ny - 1 - y);
                CAPTURE(x);
                CAPTURE(y);
                REQUIRE(is_alike);
            }
        }
    }
}

TEST_CASE("a line cuts what it meets: nodes on it keep bonds along it alone") {
    Plane plane(some_bonds(9), PlaneSides::all(FreeSide{}),
                {.nx = 30, .ny = 30, .time_step = 0.01});
    plane.cut({10, 10}, {19, 19});
    CHECK(plane.damage(15, 15) == doctest::Approx(1 - 4.0 / 28));  // (1, 1), (2, 2) and back
    CHECK(plane.damage(15, 14) == plane.damage(14, 15));
    CHECK(plane.damage(15, 14) > 0.3);
    CHECK(plane.damage(5, 20) == 0);
    CHECK(plane.damage(0, 0) == 0);  // of the bonds that a corner has
    Plane between(some_bonds(1), PlaneSides::all(FreeSide{}),
                  {.nx = 10, .ny = 10, .time_step = 0.01});
    between.cut({-0.5, 4.5}, {4.5, 4.5});
    CHECK(between.damage(4, 4) == 0.25);
    CHECK(between.damage(5, 4) == 0);
    CHECK(between.damage(0, 5) == doctest::Approx(1.0 / 3));
    Plane around(some_bonds(1), PlaneSides::all(PeriodicSide{}),
                 {.nx = 10, .ny = 10, .time_step = 0.01});
    around.cut({9.5, 2}, {9.5, 4});
    CHECK(around.damage(9, 3) == 0.25);
    CHECK(around.damage(0, 3) == 0.25);
}

TEST_CASE("bonds of kept nodes never break, and a state goes on bit for bit") {
    const BondModel model = some_bonds(4);
    const PlaneSides sides = PlaneSides::all(FreeSide{});
    const PlaneParameters p = parameters(20, 20, model, sides);
    const auto keep = [](std::ptrdiff_t x, std::ptrdiff_t /*y*/) { return x < 5; };
    Plane plane(model, sides, p);
    fill_at_random(plane, 9);
    plane.start();
    plane.break_above(1.5, keep);
    plane.advance(50);
    const PlaneState<double> state = plane.state();
    plane.advance(50);
    CHECK(plane.broken() > 100);
    for (std::size_t y = 0; y < 20; ++y) {
        CHECK(plane.damage(2, y) == 0);
    }
    Plane other(model, sides, p);
    other.break_above(1.5, keep);
    other.resume(state);
    other.advance(50);
    CHECK(other.state().displacement == plane.state().displacement);
    CHECK(other.state().bonds == plane.state().bonds);
    CHECK(other.released() == plane.released());
    Plane of_nodes(nopd2d(4, 0.25, 1), sides, p);
    CHECK_THROWS_AS(of_nodes.resume(state), std::invalid_argument);
    CHECK_THROWS_AS(of_nodes.cut({0, 0}, {1, 1}), std::logic_error);
    CHECK_THROWS_AS(of_nodes.released(), std::logic_error);
    CHECK_THROWS_AS(plane.damage(0, 20), std::invalid_argument);
    CHECK_THROWS_AS(plane.cut({1, 1}, {1, 1}), std::invalid_argument);
    CHECK_THROWS_AS(plane.cut({-std::numeric_limits<double>::infinity(), 1}, {1, 1}),
                    std::invalid_argument);
    PlaneState<double> wrong = state;
    std::ranges::fill(wrong.bonds, ~0U);
    CHECK_THROWS_AS(other.resume(wrong), std::invalid_argument);
}

TEST_CASE("a lattice with weights below 0 may not break, and explodes where it does") {
    // nmbcgen bonds --dimension 2 --horizon 2 --method bz-ls
    const BondModel model = bond2d(4, bond_weights(4, {6.759321, 1.480961, -2.332463}));
    CHECK_FALSE(is_positive(model));
    const PlaneSides sides = PlaneSides::all(FixedSide{});
    const PlaneParameters p = parameters(20, 20, model, sides);
    const auto grown = [&](double stretch) {
        Plane plane(model, sides, p);
        CHECK_THROWS_AS(plane.break_above(stretch, no_node), std::invalid_argument);
        plane.break_above(stretch, no_node, allow_unstable);
        fill_at_random(plane, 2);
        plane.start();
        const double before = plane.energies().total();
        plane.advance(300);
        return std::abs(plane.energies().total()) / before;
    };
    CHECK(grown(100) < 2);  // none breaks; `total` differs from what is kept by O(dt^2)
    CHECK(grown(1) > 1e6);
}

TEST_CASE("models of bonds that there are not") {
    CHECK_THROWS_AS(bond2d(3, {1, 1}), std::invalid_argument);
    CHECK_THROWS_AS(bond2d(2, {1}), std::invalid_argument);
    CHECK_THROWS_AS(bond2d(2, {1, 0}), std::invalid_argument);
    CHECK_THROWS_AS(bond2d(2, {1, -1}), std::invalid_argument);
    const BondModel model = bond2d(2, {1, 0.5});
    CHECK(model.speed_P() == doctest::Approx(std::sqrt(2.0)));
    CHECK(model.speed_S() == doctest::Approx(1));
    // Alebrahim 2022 at alpha = 1: (52) is 12 delta s_0^2/(5 pi); the lattice's sum is another one.
    const BondModel original = bond2d(9, bond_weights(9, {1, 1, 1, 1, 1, 1}));
    CHECK(fracture_energy(original, 2) / (4 * 12 * 3 / (5 * std::numbers::pi)) ==
          doctest::Approx(1.026).epsilon(5e-4));
    CHECK_THROWS_AS(bond_weights(8, {1, 1, 1, 1, 1}), std::invalid_argument);
    Plane plane(model, PlaneSides::all(FixedSide{}), {.nx = 9, .ny = 9, .time_step = 0.1});
    for (const double stretch : {0.0, -1.0, std::nan("")}) {
        CHECK_THROWS_AS(plane.break_above(stretch, no_node), std::invalid_argument);
    }
    PassiveSide passive = some_passive_side(0);
    passive.made_for = bond2d(2, {1, 0.6});
    CHECK_THROWS_AS(Plane(model, PlaneSides::all(passive), plane.parameters()),
                    std::invalid_argument);
    passive.made_for = nopd2d(1, 0.25, 1);
    CHECK_THROWS_AS(Plane(model, PlaneSides::all(passive), plane.parameters()),
                    std::invalid_argument);
    passive.made_for = model;
    passive.null_lagrangian = 0.1;  // bonds have none
    CHECK_THROWS_AS(Plane(model, PlaneSides::all(passive), plane.parameters()),
                    std::invalid_argument);
}
