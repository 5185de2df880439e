// SPDX-License-Identifier: MIT
/// The drive of a scene, (57): nodes whose displacement is prescribed for a while.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"
#include "tools/nmbcrun/simulation/preload.hpp"

namespace nmbcrun {

/// The drive's velocities for one step: u reaches its prescribed value, on top of the preload's, at
/// the new time.
class Driver {
  public:
    /// time_step [time]. Throws SceneError where no node is driven.
    Driver(const Scene& scene, double time_step);

    /// Whether the nodes are driven in the step that ends at this time.
    bool drives(double time) const { return time <= drive_.duration + time_step_ / 2; }

    /// Overwrites the velocities of the driven nodes in the step that ends at this time.
    /// u, v: all nodes, ghosts included; first_interior: entry of the first interior node.
    void operator()(std::span<const double> u, std::span<double> v, std::size_t first_interior,
                    double time) const;

  private:
    Drive drive_;
    PreloadField preload_;
    double time_step_;
    std::vector<std::size_t> driven_;  // from 0
};

}  // namespace nmbcrun
