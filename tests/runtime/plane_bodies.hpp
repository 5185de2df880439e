// SPDX-License-Identifier: MIT
// What the tests of all plane models set up and look at.
#pragma once

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <nmbc/plane.hpp>
#include <nmbc/plane_stability.hpp>
#include <numbers>
#include <random>
#include <vector>

inline constexpr double eps = std::numeric_limits<double>::epsilon();

/// Numbers as a designed side has them, of two layers.
inline nmbc::PassiveSide some_passive_side(double beta) {
    return {.strain = {0.4, 0.95},
            .stabilisation = {0.5, 1.1},
            .mass = {std::vector<double>{0.53, 0.87}, {0.46, 0.956}},
            .dashpots = {std::vector<double>{0.92, 0.03, 0.03, 0.01}, {0.43, 0.04, 0.04, 0.004}},
            .null_lagrangian = beta};
}

/// No unit is 1 by chance. cfl: of the lattice without its sides.
inline nmbc::PlaneParameters body_parameters(std::size_t nx, std::size_t ny,
                                             const nmbc::PlaneModel& model, double cfl = 0.5) {
    nmbc::PlaneParameters p{.nx = nx, .ny = ny, .spacing = 0.5, .youngs_modulus = 7, .density = 3};
    p.time_step = cfl * 2 / std::sqrt(nmbc::highest_eigenvalue(model)) / p.rate();
    return p;
}

template <class Real>
void fill_at_random(nmbc::BasicPlane<Real>& plane, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (std::size_t y = 0; y < plane.parameters().ny; ++y) {
        for (std::size_t x = 0; x < plane.parameters().nx; ++x) {
            for (const std::size_t a : {0U, 1U}) {
                plane.displacement(a)[plane.entry(x, y)] = static_cast<Real>(uniform(engine));
                plane.velocity(a)[plane.entry(x, y)] = static_cast<Real>(uniform(engine));
            }
        }
    }
}

inline double sum_of(const std::array<double, 4>& values) {
    return values[0] + values[1] + values[2] + values[3];
}

/// That standing P and S waves of a periodic body of 16 x 16 nodes go through cos(omega t), omega
/// that of the lattice in steps of time.
inline void check_standing_waves(const nmbc::PlaneModel& model, const nmbc::PlaneParameters& p) {
    constexpr std::size_t n = 16;
    nmbc::Plane plane(model, nmbc::PlaneSides::all(nmbc::PeriodicSide{}), p);
    const double xi_x = 2 * std::numbers::pi * 2 / n;
    const double xi_y = 2 * std::numbers::pi * 3 / n;
    for (const bool is_P : {true, false}) {
        CAPTURE(is_P);
        const nmbc::PlaneWave wave = nmbc::plane_wave(model, {xi_x, xi_y}, is_P);
        for (std::size_t y = 0; y < n; ++y) {
            for (std::size_t x = 0; x < n; ++x) {
                for (const std::size_t a : {0U, 1U}) {
                    plane.displacement(a)[plane.entry(x, y)] =
                        wave.direction[a] * std::cos(xi_x * double(x) + xi_y * double(y));
                    plane.velocity(a)[plane.entry(x, y)] = 0;
                }
            }
        }
        plane.start();
        constexpr std::size_t steps = 40;
        plane.advance(steps);
        // cos(k theta) after k steps, omega = (2/dt) sin(theta/2).
        const double theta =
            2 * std::asin(p.rate() * std::sqrt(wave.omega_squared) * p.time_step / 2);
        for (const std::size_t a : {0U, 1U}) {
            CHECK(plane.displacement(a)[plane.entry(0, 0)] ==
                  doctest::Approx(wave.direction[a] * std::cos(steps * theta))
                      .epsilon(1000 * eps)  // the roundings of 40 steps
                      .scale(1));
        }
    }
}
