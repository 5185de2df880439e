// SPDX-License-Identifier: MIT
/// The longest step of a plane between its sides.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <nmbc/plane.hpp>
#include <vector>

namespace nmbc {

namespace detail {

/// One step of U_{k+1}(x) = 2 x U_k(x) - U_{k-1}(x), x = 2 M^-1 K/band - 1, of Chebyshev's
/// polynomials of the second kind. The displacement is U_k u, `before` U_{k-1} u; both are divided
/// by the length of the displacement. Returns |M^-1 K u|/|u| of the displacement it was given. The
/// plane has steps of 2.
inline double chebyshev_step(Plane& body, std::array<std::vector<double>, 2>& before, double band) {
    for (const std::size_t a : {0U, 1U}) {
        std::ranges::fill(body.velocity(a), 0.0);
    }
    body.start();
    // Ghosts have no forces, and no part in it: a periodic side copies theirs, others hold them.
    double square = 0;
    double square_of_image = 0;
    for (const std::size_t a : {0U, 1U}) {
        for (std::size_t node = 0; node < before[a].size(); ++node) {
            const double image = body.velocity(a)[node];
            const double u = image != 0 ? body.displacement(a)[node] : 0;
            square += u * u;
            square_of_image += image * image;
        }
    }
    const double scale = 1 / std::sqrt(square);
    for (const std::size_t a : {0U, 1U}) {
        for (std::size_t node = 0; node < before[a].size(); ++node) {
            const double image = body.velocity(a)[node];
            double& u = body.displacement(a)[node];
            const double next = 2 * (2 / band * image - u) - before[a][node];
            before[a][node] = scale * u;
            u = image != 0 ? scale * next : 0;
        }
    }
    return scale * std::sqrt(square_of_image);
}

}  // namespace detail

/// The highest eigenvalue of M^-1 K, where E = density = dX = 1, of nx times ny interior nodes
/// between these sides: steps are stable while dt^2 times it is below 4. It is the larger one of
/// the interior and of the body, or of 48 n nodes along an axis where it has more, found by
/// Chebyshev iteration; 1 % is added. Throws as BasicPlane's constructor.
inline double highest_eigenvalue(const PlaneModel& model, const PlaneSides& sides, std::size_t nx,
                                 std::size_t ny) {
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
    // U_k(2 M^-1 K/band - 1) u, with U_k Chebyshev's polynomials of the second kind, lets what is a
    // share x above [0, band] grow as exp(2 k sqrt(x)). The band is the interior's, then all but
    // the last hundredth of what was found.
    constexpr int stages = 3;
    constexpr int iterations = 50;  // of each
    const double interior = highest_eigenvalue(model);
    double band = interior;
    double found = 0;
    for (int stage = 0; stage < stages; ++stage) {
        std::array<std::vector<double>, 2> before{std::vector<double>(body.displacement(0).size()),
                                                  std::vector<double>(body.displacement(1).size())};
        for (int i = 0; i < iterations; ++i) {
            found = detail::chebyshev_step(body, before, band);
        }
        band = 0.99 * found;
    }
    constexpr double not_found = 1.01;
    return not_found * std::max(interior, found);  // found is NaN where nothing moves
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
