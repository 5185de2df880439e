// SPDX-License-Identifier: MIT
/// Why perfectly matched layers do not grow: their equations, wave by wave.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/dense/decompositions.hpp"

TEST_CASE("where losses are constant no wave grows") {
    CHECK(rc::check("of any lattice, at any losses", [] {
        const auto part = [](int lowest) { return *rc::gen::inRange(lowest, 1001) / 1000.0; };
        const double sigma_x = 20 * part(0);  // times dt/2
        const double sigma_y = 20 * part(0);
        const double x = part(0);
        const double y = part(0);
        const double s = part(0);
        const double of_limit = part(1) * 0.999 / std::max(x + y + s, 1e-3);
        // One wave: omega^2 dt^2/4 = (x + y + s) of_limit < 1; u, v dt, what the losses remember of
        // the gradients along x and y, and of the forces.
        Eigen::MatrixXd step(6, 6);
        for (int column = 0; column < 6; ++column) {
            Eigen::Matrix<double, 6, 1> state = Eigen::Matrix<double, 6, 1>::Unit(column);
            const auto taken = [&state](int place, double h, double f) {
                const double q = (state(place) + h * f) / (1 + h);
                state(place) = (1 - h) * q + h * f;
                return q;
            };
            double force = -4 * of_limit * s * state(0);
            int place = 2;
            for (const auto& [square, h] : {std::pair{x, sigma_x}, std::pair{y, sigma_y}}) {
                const double slope = 2 * std::sqrt(of_limit * square);
                const double stress = slope * (state(0) - taken(place, h, state(0)));
                force -= slope * (stress - taken(place + 1, h, stress));
                place += 2;
            }
            state(1) += force;
            state(0) += state(1);
            step.col(column) = state;
        }
        const double largest = nmbcgen::eigenvalues(step).cwiseAbs().maxCoeff();
        // Double eigenvalues 1, where x, y or losses are 0, are found to the root of the roundings.
        RC_ASSERT(largest < 1 + 1e-6);
    }));
}
