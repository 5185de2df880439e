// SPDX-License-Identifier: MIT
/// Passive sides as nmbcrun designs them, on all four sides of a small body, for as long as one
/// runs.
#include <doctest/doctest.h>

#include <cmath>
#include <nmbc/plane_stability.hpp>
#include <numbers>
#include <random>

#include "generator/passive/plane_side.hpp"

namespace {

/// From random data: the energy never rises beyond the roundings of its own steps.
template <class Real>
void never_rises(const nmbc::PlaneModel& model, const nmbc::PassiveSide& side, std::size_t steps,
                 double roundings) {
    const auto sides = nmbc::PlaneSides::all(side);
    nmbc::PlaneParameters p{.nx = 9, .ny = 12};
    p.time_step = 0.99 * 2 / std::sqrt(nmbc::highest_eigenvalue(model, sides, p.nx, p.ny));
    nmbc::BasicPlane<Real> plane(model, sides, p);
    std::mt19937 engine(2018);
    std::uniform_real_distribution<Real> uniform(-1, 1);
    for (std::size_t y = 0; y < p.ny; ++y) {
        for (std::size_t x = 0; x < p.nx; ++x) {
            for (const std::size_t a : {0U, 1U}) {
                plane.displacement(a)[plane.entry(x, y)] = uniform(engine);
                plane.velocity(a)[plane.entry(x, y)] = uniform(engine);
            }
        }
    }
    plane.start();
    plane.advance(1);
    const double first = plane.energies().staggered;
    double last = first;
    for (std::size_t look = 0; look < 100; ++look) {
        plane.advance(steps / 100);
        const double now = plane.energies().staggered;
        // Rounded displacements of what is left, a rigid shift, make energies of their own.
        CHECK(now <= last * (1 + roundings) + roundings * roundings * first * 1e3);
        last = now;
    }
    // Slow short waves take longer: of 200 000 steps at most 8e-3 is left, of 10 000 at most 2e-1.
    CHECK(last < 0.4 * first);
}

}  // namespace

TEST_CASE("between passive sides energy never rises") {
    for (const unsigned radius_squared : {1U, 2U, 4U, 5U, 8U, 9U}) {
        for (const double G : {0.0, 0.25, 1.0}) {
            CAPTURE(radius_squared);
            CAPTURE(G);
            const nmbcgen::DesignedSide designed = nmbcgen::passive_side(
                {.family = "nopd2d",
                 .choice = {.radius_squared = radius_squared, .poisson = nmbcgen::Rational(1, 4)},
                 .g = nmbcgen::Rational(G / std::numbers::pi),
                 .time_step = 0});
            const nmbc::PassiveSide side = for_runtime(designed);
            const nmbc::PlaneModel model = nmbc::nopd2d(radius_squared, 0.25, G);
            // All were run for 200 000 once; it takes six minutes.
            const std::size_t steps = radius_squared == 1 ? 200'000 : 10'000;
            never_rises<double>(model, side, steps, 1e-12);
            never_rises<float>(model, side, steps, 1e-4);
        }
    }
}
