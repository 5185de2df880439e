// SPDX-License-Identifier: MIT
/// The neighbours of a node of a plane lattice.
#pragma once

#include <array>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace nmbc {

/// From a node to one of its neighbours [dX].
struct PlaneOffset {
    int x = 0;
    int y = 0;

    friend bool operator==(const PlaneOffset&, const PlaneOffset&) = default;
};

/// The neighbours of a node: all offsets with 0 < x^2 + y^2 <= radius_squared.
inline std::vector<PlaneOffset> plane_family(unsigned radius_squared) {
    std::vector<PlaneOffset> family;
    const auto bound = static_cast<int>(radius_squared);
    for (int y = -bound; y <= bound; ++y) {
        for (int x = -bound; x <= bound; ++x) {
            const int square = x * x + y * y;
            if (square > 0 && square <= bound) {
                family.push_back({x, y});
            }
        }
    }
    return family;
}

/// n: the farthest neighbour along an axis [dX].
inline std::size_t horizon_of(unsigned radius_squared) {
    std::size_t n = 0;
    while ((n + 1) * (n + 1) <= radius_squared) {
        ++n;
    }
    return n;
}

namespace detail {

/// Throws std::invalid_argument where no node has exactly this distance.
inline void require_radius(unsigned radius_squared) {
    for (const PlaneOffset& bond : plane_family(radius_squared)) {
        if (bond.x * bond.x + bond.y * bond.y == static_cast<int>(radius_squared)) {
            return;
        }
    }
    throw std::invalid_argument(
        "the radius squared of a plane family must be a sum of two "
        "squares: 1, 2, 4, 5, 8, 9, 10, 13, .., not " +
        std::to_string(radius_squared));
}

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

/// A plane wave of the interior, exp(i (xi.X/dX - omega t)).
struct PlaneWave {
    double omega_squared = 0;
    std::array<double, 2> direction{};  ///< of u, of length 1
};

}  // namespace nmbc
