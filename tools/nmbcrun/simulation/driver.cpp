// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/simulation/driver.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/simulation/nodes_within.hpp"

namespace nmbcrun {

Driver::Driver(const Scene& scene, double time_step)
    : drive_(*scene.drive),
      preload_(scene),
      time_step_(time_step),
      driven_(
          nodes_within(scene, drive_.centre, drive_.half_width * scene.horizon * scene.spacing)) {
    if (driven_.empty()) {
        throw SceneError("drive.centre and drive.half_width select no node");
    }
}

void Driver::operator()(std::span<const double> u, std::span<double> v, std::size_t first_interior,
                        double time) const {
    if (!drives(time)) {
        return;
    }
    const double phase = std::numbers::pi * std::min(time / drive_.duration, 1.0);
    const double value = drive_.amplitude / 2 * (1 - std::cos(phase));
    for (const std::size_t node : driven_) {
        const std::size_t entry = first_interior + node;
        v[entry] = (value + preload_(double(node + 1)) - u[entry]) / time_step_;
    }
}

}  // namespace nmbcrun
