// SPDX-License-Identifier: MIT
/// One-dimensional bond-based peridynamics, linearised.
#include <fmt/format.h>

#include <utility>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"

namespace nmbcgen {

Model bond1d(unsigned horizon, std::span<const Rational> weights) {
    // A bond's force is its influence times its stretch (u_{I+m} - u_I)/m, so that its spring
    // constant is k w_m/m. omega^2 = sum_m (k w_m/m) 2 (1 - cos m xi) starts as k sum w_m m xi^2,
    // and c = 1 sets k.
    Rational stiffness = 0;
    for (unsigned m = 1; m <= horizon; ++m) {
        stiffness += weights[m - 1] * m;
    }
    if (stiffness <= 0) {
        throw NoSuchModel("with these weights long waves do not travel: sum of m w_m is " +
                          to_string(stiffness));
    }
    std::vector<ExactSquare> energy;
    for (unsigned m = 1; m <= horizon; ++m) {
        std::vector<Rational> extension(2 * std::size_t(m) + 1);
        extension[m] = -1;
        extension[2 * std::size_t(m)] = 1;
        energy.push_back(
            {EnergyPart::strain, constant(weights[m - 1] / (m * stiffness)), std::move(extension)});
    }
    return {.description = fmt::format("1D bond-based peridynamics, horizon {} dX", horizon),
            .source = "Silling 2000: bond-based, linear in the stretch of a bond",
            .energy = std::move(energy),
            .symbol = {},
            .damping = {}};
}

}  // namespace nmbcgen
