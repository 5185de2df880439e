// SPDX-License-Identifier: GPL-2.0-or-later
/// A plane of radius 1 between sides that sum by parts: half of the volume and the mass on the
/// surface, a quarter in corners. Evenly strained under the tractions of that strain it rests.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <nmbc/plane.hpp>
#include <nmbc/plane_stability.hpp>
#include <utility>
#include <vector>

namespace {

constexpr double poisson = 0.3;

nmbc::PassiveSide half() {
    const std::vector<double> weight{0.5};
    return {.strain = weight,
            .stabilisation = weight,
            .mass = {weight, weight},
            .dashpots = {std::vector<double>{0}, std::vector<double>{0}}};
}

/// The largest departure over the largest displacement, in 200 steps: a free body flies off with
/// the square of their number, by a rounding of its forces. gradient: xx, xy, yx, yy.
double failure_of_patch(double G, const std::array<double, 4>& gradient) {
    const nmbc::PlaneModel model = nmbc::nopd2d(1, poisson, G);
    const auto sides = nmbc::PlaneSides::all(half());
    nmbc::PlaneParameters p{.nx = 12, .ny = 9, .spacing = 0.5, .youngs_modulus = 7, .density = 3};
    p.time_step = 1.8 / std::sqrt(nmbc::highest_eigenvalue(model, sides, p.nx, p.ny)) / p.rate();
    nmbc::Plane plane(model, sides, p);
    const nmbc::Grid grid = plane.grid();
    const std::size_t ghosts = plane.ghosts();
    std::array<std::vector<double>, 2> u{std::vector<double>(grid.nx * grid.ny),
                                         std::vector<double>(grid.nx * grid.ny)};
    for (std::size_t y = ghosts; y + ghosts < grid.ny; ++y) {
        for (std::size_t x = ghosts; x + ghosts < grid.nx; ++x) {
            for (const std::size_t a : {0U, 1U}) {
                u[a][y * grid.nx + x] =
                    p.spacing * (gradient[2 * a] * double(x) + gradient[2 * a + 1] * double(y));
                plane.displacement(a)[y * grid.nx + x] = u[a][y * grid.nx + x];
            }
        }
    }
    const double modulus = p.youngs_modulus / (1 - poisson * poisson);  // plane stress
    const double sigma_x = modulus * (gradient[0] + poisson * gradient[3]);
    const double sigma_y = modulus * (gradient[3] + poisson * gradient[0]);
    const double sigma_xy = p.youngs_modulus / (2 * (1 + poisson)) * (gradient[1] + gradient[2]);
    // On half a cell, in corners from two sides on a quarter of one: the same change of v.
    const auto pull = [&](double duration) {
        const double push = 2 * duration / (p.density * p.spacing);
        for (std::size_t y = ghosts; y + ghosts < grid.ny; ++y) {
            for (std::size_t x = ghosts; x + ghosts < grid.nx; ++x) {
                const int out_x = int(x + ghosts + 1 == grid.nx) - int(x == ghosts);
                const int out_y = int(y + ghosts + 1 == grid.ny) - int(y == ghosts);
                const std::size_t entry = y * grid.nx + x;
                plane.velocity(0)[entry] += push * (out_x * sigma_x + out_y * sigma_xy);
                plane.velocity(1)[entry] += push * (out_x * sigma_xy + out_y * sigma_y);
            }
        }
    };
    plane.start();
    pull(-p.time_step / 2);
    plane.advance(
        200, [&](auto&, double) { pull(p.time_step); }, [](const auto&) {});
    double failure = 0;
    double largest = 0;
    for (std::size_t entry = 0; entry < grid.nx * grid.ny; ++entry) {
        for (const std::size_t a : {0U, 1U}) {
            failure = std::max(failure,
                               std::abs(std::as_const(plane).displacement(a)[entry] - u[a][entry]));
            largest = std::max(largest, std::abs(u[a][entry]));
        }
    }
    return failure / largest;
}

}  // namespace

TEST_CASE("sides that sum by parts pass the patch test, corners included") {
    for (const double G : {0.0, 0.5}) {
        CAPTURE(G);
        CHECK(failure_of_patch(G, {0.1, 0, 0, 0.02}) < 1e-12);
        CHECK(failure_of_patch(G, {0, 0.05, 0.05, 0}) < 1e-12);
        CHECK(failure_of_patch(G, {0.03, 0.1, -0.04, -0.02}) < 1e-12);
    }
}

TEST_CASE("between such sides the energy is kept") {
    const nmbc::PlaneModel model = nmbc::nopd2d(1, poisson, 0.5);
    const auto sides = nmbc::PlaneSides::all(half());
    nmbc::PlaneParameters p{.nx = 12, .ny = 9};
    p.time_step = 1.8 / std::sqrt(nmbc::highest_eigenvalue(model, sides, p.nx, p.ny));
    nmbc::Plane plane(model, sides, p);
    plane.displacement(0)[plane.entry(3, 4)] = 1;
    plane.displacement(1)[plane.entry(7, 0)] = -1;
    plane.start();
    const double start = plane.energies().staggered;
    double drift = 0;
    for (int step = 0; step < 1000; ++step) {
        plane.advance(1);
        drift = std::max(drift, std::abs(plane.energies().staggered / start - 1));
    }
    CHECK(drift < 1e-12);  // 1000 steps of roundings
}
