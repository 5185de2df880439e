// SPDX-License-Identifier: MIT
/// The longest step of a plane between its sides.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nmbc/plane.hpp>
#include <variant>

namespace nmbc {

/// The highest eigenvalue of M^-1 K, where E = density = dX = 1, of nx times ny interior nodes
/// between these sides: steps are stable while dt^2 times it is below 4. It is the larger one of
/// the interior and of the body, or of 48 n nodes along an axis where it has more, found by power
/// iteration; 1 % is added. Throws as BasicPlane's constructor.
inline double highest_eigenvalue(const PlaneModel& model, const PlaneSides& sides, std::size_t nx,
                                 std::size_t ny) {
    constexpr std::size_t iterations = 1000;
    PlaneSides held = sides;  // what moves by conditions is held
    for (PlaneSide* const side : {&held.left, &held.right, &held.bottom, &held.top}) {
        if (!detail::is_cut(*side) && !std::holds_alternative<PeriodicSide>(*side)) {
            *side = FixedSide{};
        }
    }
    // v at -dt/2 is -dt/2 times the acceleration, so that steps of 2 make it M^-1 K u.
    const std::size_t large = 48 * model.horizon();
    PlaneParameters p{.nx = std::min(nx, large), .ny = std::min(ny, large)};
    p.time_step = 2;
    Plane body(model, held, p);
    for (const std::size_t a : {0U, 1U}) {
        double value = 0.1;
        for (double& u : body.displacement(a)) {
            value = 4 * value * (1 - value);  // as good as random, and the same everywhere
            u = value - 0.5;
        }
    }
    double estimate = 0;
    for (std::size_t i = 0; i < iterations; ++i) {
        for (const std::size_t a : {0U, 1U}) {
            std::ranges::fill(body.velocity(a), 0.0);
        }
        body.start();
        double square = 0;  // of a displacement of length 1, but for the first one
        for (const std::size_t a : {0U, 1U}) {
            for (const double v : body.velocity(a)) {
                square += v * v;
            }
        }
        estimate = std::sqrt(square);
        for (const std::size_t a : {0U, 1U}) {
            std::ranges::transform(body.velocity(a), body.displacement(a).begin(),
                                   [=](double v) { return v / estimate; });
        }
    }
    constexpr double not_found = 1.01;
    return not_found * std::max(highest_eigenvalue(model), estimate);
}

}  // namespace nmbc
