// SPDX-License-Identifier: MIT
/// Waves of a plane lattice.
#pragma once

#include <array>
#include <numbers>

namespace nmbc {

/// A plane wave of the interior, exp(i (xi.X/dX - omega t)).
struct PlaneWave {
    double omega_squared = 0;
    std::array<double, 2> direction{};  ///< of u, of length 1
};

namespace detail {

/// Calls visit(xi) for wave vectors in steps of pi/64, one of each eight that are alike; not 0.
template <class Visit>
void for_each_wave_vector(const Visit& visit) {
    constexpr int steps = 64;
    for (int x = 1; x <= steps; ++x) {
        for (int y = 0; y <= x; ++y) {
            visit(
                std::array<double, 2>{std::numbers::pi * x / steps, std::numbers::pi * y / steps});
        }
    }
}

}  // namespace detail

}  // namespace nmbc
