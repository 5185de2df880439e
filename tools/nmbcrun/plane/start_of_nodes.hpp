// SPDX-License-Identifier: MIT
/// u and v that the nodes of a plane begin with.
#pragma once

#include <array>
#include <cstddef>

#include "tools/nmbcrun/stepping/plane_stepping.hpp"

namespace nmbcrun {

struct StartOfNode {
    std::array<double, 2> u{};
    std::array<double, 2> v{};
};

/// By the scene's nodes, which are 0 .. n - 1 along each axis; others are of layers.
class StartOfNodes {
  public:
    /// nodes: of the scene; extension: those that extended sides add, in the order of
    /// nmbc::plane_sides.
    StartOfNodes(const std::array<std::size_t, 2>& nodes,
                 const std::array<std::size_t, 4>& extension, nmbc::Plane& plane)
        : plane_(plane), first_entry_(plane.entry(extension[0], extension[2])) {
        for (const std::size_t axis : {0U, 1U}) {
            const auto before = [&](std::size_t side) {
                return std::ptrdiff_t(plane.layers()[side] + extension[side]);
            };
            first_[axis] = -before(2 * axis);
            last_[axis] = std::ptrdiff_t(nodes[axis]) + before(2 * axis + 1);
        }
    }

    std::ptrdiff_t first(std::size_t axis) const { return first_[axis]; }
    /// Behind the last one.
    std::ptrdiff_t last(std::size_t axis) const { return last_[axis]; }
    bool has(std::size_t axis, std::ptrdiff_t node) const {
        return node >= first_[axis] && node < last_[axis];
    }

    void set(std::ptrdiff_t x, std::ptrdiff_t y, const StartOfNode& start) {
        const std::size_t entry = first_entry_ + std::size_t(y) * plane_.grid().nx + std::size_t(x);
        for (const std::size_t a : {0U, 1U}) {
            plane_.displacement(a)[entry] = start.u[a];
            plane_.velocity(a)[entry] = start.v[a];
        }
    }

  private:
    nmbc::Plane& plane_;
    std::size_t first_entry_;
    std::array<std::ptrdiff_t, 2> first_{};
    std::array<std::ptrdiff_t, 2> last_{};
};

}  // namespace nmbcrun
