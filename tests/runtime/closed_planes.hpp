// SPDX-License-Identifier: MIT
// What the tests of planes between closed sides set up and look at.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nmbc/plane.hpp>
#include <nmbc/plane_stability.hpp>
#include <numeric>
#include <utility>
#include <vector>

inline nmbc::PlaneParameters parameters_of(const nmbc::PlaneModel& model,
                                           const nmbc::PlaneSides& sides, std::size_t nx = 9,
                                           std::size_t ny = 7) {
    nmbc::PlaneParameters p{.nx = nx, .ny = ny, .spacing = 0.5, .youngs_modulus = 7, .density = 3};
    p.time_step = 1.8 / std::sqrt(nmbc::highest_eigenvalue(model, sides, p.nx, p.ny)) / p.rate();
    return p;
}

/// Calls work(x, y, entry) for the nodes of the body, counted from its lower left corner.
template <class Work>
void for_each_node(const nmbc::Plane& plane, const Work& work) {
    const std::size_t ghosts = plane.ghosts();
    for (std::size_t y = 0; y + 2 * ghosts < plane.grid().ny; ++y) {
        for (std::size_t x = 0; x + 2 * ghosts < plane.grid().nx; ++x) {
            work(x, y, (y + ghosts) * plane.grid().nx + x + ghosts);
        }
    }
}

/// Of such layers, lighter and stiffer outwards, with dashpots that join them.
inline nmbc::PassiveSide absorbing(std::size_t layers, double dashpot) {
    std::vector<double> rising;
    std::vector<double> dashpots(layers * layers, 0.1 * dashpot);
    for (std::size_t i = 0; i < layers; ++i) {
        rising.push_back(0.6 + 0.1 * double(i));
        dashpots[i * (layers + 1)] = dashpot;
    }
    return {rising, rising, {rising, rising}, {dashpots, dashpots}};
}

/// Of 9 x 7 nodes between such sides, where u is linear in x and y.
inline void check_linear_gradient(const nmbc::PlaneModel& model, const nmbc::PlaneSides& sides) {
    nmbc::Plane plane(model, sides, {.nx = 9, .ny = 7, .time_step = 1e-3});
    for_each_node(plane, [&](std::size_t x, std::size_t y, std::size_t entry) {
        plane.displacement(0)[entry] = 0.1 * double(x) + 0.05 * double(y);
        plane.displacement(1)[entry] = -0.04 * double(x) + 0.02 * double(y);
    });
    const nmbc::PlaneEnergies energies = std::as_const(plane).energies();
    CHECK(energies.strain > 0.1);
    // Any other gradient would leave something of the bonds: this is of roundings squared.
    CHECK(energies.stabilisation < 1e-26 * energies.strain);
}

/// Of the energy and what has left, over what it is at the start, looked at every tenth step.
inline double largest_drift(const nmbc::PlaneModel& model, const nmbc::PlaneSides& sides,
                            const nmbc::PlaneParameters& p, int steps) {
    nmbc::Plane plane(model, sides, p);
    plane.displacement(0)[plane.entry(3, 4)] = 1;
    plane.displacement(1)[plane.entry(7, 0)] = -1;
    plane.start();
    const double start = plane.energies().staggered;
    CHECK(start > 0);
    double drift = 0;
    for (int step = 0; step < steps; step += 10) {
        plane.advance(10);
        const auto left = plane.left();
        const double all = std::accumulate(left.begin(), left.end(), plane.energies().staggered);
        drift = std::max(drift, std::abs(all / start - 1));
    }
    return drift;
}
