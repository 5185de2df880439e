// SPDX-License-Identifier: MIT
/// Physical ends as mirrors of a lattice that goes on for ever.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// The physical ends of a scene. What goes past one is its mirror image back inside, upside down at
/// a fixed end, where the outermost ghost in reach of the interior is taken for all of them.
class Mirrors {
  public:
    explicit Mirrors(const Scene& scene)
        : left_(scene.left), right_(scene.right), nodes_(scene.nodes) {}

    bool at_left() const { return is_physical(left_.kind); }
    bool at_right() const { return is_physical(right_.kind); }
    int count() const { return int(at_left()) + int(at_right()); }

    /// u of the interior nodes. field: of a WaveGrid, which has the interior from its first entry
    /// on and goes on, upside down, in front of that with its last one.
    std::vector<double> folded(std::span<const double> field) const;

  private:
    Boundary left_;
    Boundary right_;
    std::size_t nodes_;
};

}  // namespace nmbcrun
