// SPDX-License-Identifier: MIT
/// The neighbours of a node of a plane lattice.
#pragma once

#include <cstddef>
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

/// n: the farthest neighbour along an axis [dX].
inline std::size_t horizon_of(unsigned radius_squared) {
    std::size_t n = 0;
    while ((n + 1) * (n + 1) <= radius_squared) {
        ++n;
    }
    return n;
}

/// The neighbours of a node: all offsets with 0 < x^2 + y^2 <= radius_squared. Throws
/// std::invalid_argument of more than 1000000, a thousand dX and three million neighbours.
inline std::vector<PlaneOffset> plane_family(unsigned radius_squared) {
    constexpr unsigned largest = 1'000'000;  // x^2 + y^2 stays far below INT_MAX
    if (radius_squared > largest) {
        throw std::invalid_argument("the radius squared of a plane family must be at most " +
                                    std::to_string(largest) + ", not " +
                                    std::to_string(radius_squared));
    }
    std::vector<PlaneOffset> family;
    const auto n = static_cast<int>(horizon_of(radius_squared));
    for (int y = -n; y <= n; ++y) {
        for (int x = -n; x <= n; ++x) {
            const int square = x * x + y * y;
            if (square > 0 && square <= static_cast<int>(radius_squared)) {
                family.push_back({x, y});
            }
        }
    }
    return family;
}

namespace detail {

/// Nodes of a line: first .. last - 1.
struct PlaneRange {
    std::ptrdiff_t first = 0;
    std::ptrdiff_t last = 0;
};

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

}  // namespace detail

}  // namespace nmbc
