// SPDX-License-Identifier: MIT
/// The drive of a scene, (57): nodes whose displacement is prescribed for a while.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"
#include "tools/nmbcrun/sources/preload.hpp"

namespace nmbcrun {

/// The drive's velocities, step by step. While it lasts, u reaches its prescribed value, on top of
/// the preload's, at the new time. The step after that lets the nodes go from rest, as they are at
/// the end of the drive, wherever between two time levels this is: v is the lattice's acceleration
/// times the time from there to the middle of the step. So the error of steps is of second order
/// where the lattice is undamped.
class Driver {
  public:
    /// time_step [time]. Throws SceneError where no node is driven, or for no more than a step.
    Driver(const Scene& scene, double time_step);

    /// Whether the nodes are driven, or let go, in the step that ends at this time.
    bool drives(double time) const { return time <= (last_ + 1.5) * time_step_; }

    /// From 0.
    const std::vector<std::size_t>& nodes() const { return driven_; }

    /// Overwrites the velocities of the driven nodes in the step that ends at this time.
    /// u, v: all nodes, ghosts included, v as the forces have made it; first_interior: entry of the
    /// first interior node.
    void operator()(std::span<const double> u, std::span<double> v, std::size_t first_interior,
                    double time) const;

  private:
    /// What is prescribed at this time [length].
    double value(double time) const;

    /// The first step after the drive. v: of the nodes from the first interior one on.
    void let_go(std::span<double> v) const;

    Drive drive_;
    PreloadField preload_;
    double time_step_;
    double last_;                      // steps in which u is prescribed
    std::vector<std::size_t> driven_;  // from 0
};

}  // namespace nmbcrun
