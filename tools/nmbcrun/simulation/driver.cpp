// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/simulation/driver.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {

Driver::Driver(const Scene& scene, std::size_t first_interior, double time_step)
    : drive_(scene.drive), time_step_(time_step) {
    const double reach = drive_.half_width * scene.horizon * scene.spacing;
    // Positions are rounded; a billionth of a spacing decides nothing on purpose.
    const double slack = 1e-9 * scene.spacing;
    for (std::size_t node = 0; node < scene.nodes; ++node) {
        const double X = double(node + 1) * scene.spacing;
        if (std::abs(X - drive_.centre) <= reach + slack) {
            driven_.push_back(node + first_interior);
        }
    }
    if (driven_.empty()) {
        throw SceneError("drive.centre and drive.half_width select no node");
    }
}

void Driver::operator()(std::span<const double> u, std::span<double> v, double time) const {
    if (!drives(time)) {
        return;
    }
    const double phase = std::numbers::pi * std::min(time / drive_.duration, 1.0);
    const double value = drive_.amplitude / 2 * (1 - std::cos(phase));
    for (const std::size_t node : driven_) {
        v[node] = (value - u[node]) / time_step_;
    }
}

}  // namespace nmbcrun
