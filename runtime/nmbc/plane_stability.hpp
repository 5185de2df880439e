// SPDX-License-Identifier: MIT
/// The longest step of a plane between its sides.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nmbc/plane.hpp>

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
        if (!detail::is_cut(*side) && !detail::has_images(*side)) {
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

/// Steps below this one [where E = density = dX = 1] are stable between these sides:
/// dt^2 l + 2 dt d <= 4, with l the highest eigenvalue of M^-1 K and d that of M^-1 D of a damped
/// lattice. Throws as highest_eigenvalue().
inline double longest_step(const PlaneModel& model, const PlaneSides& sides, std::size_t nx,
                           std::size_t ny) {
    const double highest = highest_eigenvalue(model, sides, nx, ny);
    double damping = 0;
    if (const auto* const law = std::get_if<CorrespondenceModel>(&model.law());
        law != nullptr && law->damping > 0) {
        // Beside so much stabilisation the strain adds little, and nothing below 0.
        CorrespondenceModel stiff = *law;
        stiff.stabilisation = 1e3 * (law->bulk + law->shear);
        PlaneSides of_any = sides;
        for (PlaneSide* const side : {&of_any.left, &of_any.right, &of_any.bottom, &of_any.top}) {
            if (auto* const passive = std::get_if<PassiveSide>(side)) {
                passive->made_for.reset();
            }
        }
        damping = law->damping / stiff.stabilisation * highest_eigenvalue(stiff, of_any, nx, ny);
    }
    return 4 / (damping + std::sqrt(damping * damping + 4 * highest));
}

}  // namespace nmbc
