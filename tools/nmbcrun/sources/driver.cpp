// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/sources/driver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/sources/nodes_within.hpp"

namespace nmbcrun {

Driver::Driver(const Scene& scene, double time_step)
    : drive_(*scene.drive),
      preload_(scene),
      time_step_(time_step),
      // A duration of so many steps is one, whatever its last digits are.
      last_(std::ceil(drive_.duration / time_step * (1 - 1e-12))),
      driven_(require_nodes_within(scene, drive_.centre, drive_.half_width, "drive",
                                   scene.horizon * scene.spacing)) {
    if (last_ < 2) {  // the first one begins at what initial and incoming have, not at rest
        throw SceneError(
            fmt::format("drive.duration is {:.6g}, not longer than a time step of {:.6g}",
                        drive_.duration, time_step));
    }
}

double Driver::value(double time) const {
    const double phase = std::numbers::pi * std::min(time / drive_.duration, 1.0);
    return drive_.amplitude / 2 * (1 - std::cos(phase));
}

void Driver::operator()(std::span<const double> u, std::span<double> v, std::size_t first_interior,
                        double time) const {
    if (!drives(time)) {
        return;
    }
    if (time > (last_ + 0.5) * time_step_) {
        let_go(v.subspan(first_interior));
        return;
    }
    const double prescribed = value(time);
    for (const std::size_t node : driven_) {
        const std::size_t entry = first_interior + node;
        v[entry] = (prescribed + preload_(double(node + 1)) - u[entry]) / time_step_;
    }
}

void Driver::let_go(std::span<double> v) const {
    const double last_time = last_ * time_step_;
    const double last_velocity = (value(last_time) - value(last_time - time_step_)) / time_step_;
    const double since_the_end = (last_time - drive_.duration) / time_step_ + 0.5;
    for (const std::size_t node : driven_) {
        v[node] = (v[node] - last_velocity) * since_the_end;
    }
}

}  // namespace nmbcrun
