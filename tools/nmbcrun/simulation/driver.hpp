// SPDX-License-Identifier: MIT
/// The drive of a scene, (57): nodes whose displacement is prescribed for a while.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// The drive's velocities for one step: u reaches its prescribed value at the new time.
class Driver {
  public:
    /// first_interior: entry of the first interior node; time_step [time].
    /// Throws SceneError where no node is driven.
    Driver(const Scene& scene, std::size_t first_interior, double time_step);

    /// Whether the nodes are driven in the step that ends at this time.
    bool drives(double time) const { return time <= drive_.duration + time_step_ / 2; }

    /// Overwrites the velocities of the driven nodes in the step that ends at this time.
    /// u, v: all nodes, ghosts included.
    void operator()(std::span<const double> u, std::span<double> v, double time) const;

  private:
    Drive drive_;
    double time_step_;
    std::vector<std::size_t> driven_;
};

}  // namespace nmbcrun
