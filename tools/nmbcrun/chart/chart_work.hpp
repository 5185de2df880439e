// SPDX-License-Identifier: MIT
/// What the parts of a chart take.
#pragma once

#include <cstddef>

#include "tools/nmbcrun/chart/pace.hpp"
#include "tools/nmbcrun/chart/points.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// The scene in the steps of a point, between its ends.
Scene ended_by(const Scene& scene, const Point& point);

/// Seconds, as the pace of the bare interior tells; what all cores share takes a part of them.
class ChartWork {
  public:
    /// long_run: steps of it.
    ChartWork(Scene scene, const Pace& pace, std::size_t long_run);

    /// A run of this scene, which has its step and like ends.
    double run(const Scene& scene) const;

    // Of a point:
    double tuning(const Point& point) const;
    double trial(const Point& point) const;
    double long_run(const Point& point) const;
    /// On one core: bursts of the boundary beside twice as many of the bare interior, until it has
    /// taken long enough, and some while it is made.
    double timing(const Point& point) const;

  private:
    double seconds_of(const Scene& scene) const;

    Scene scene_;
    Pace pace_;
    std::size_t long_run_;
};

}  // namespace nmbcrun
