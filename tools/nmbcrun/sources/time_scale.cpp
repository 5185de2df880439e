// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/sources/time_scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace nmbcrun {

TimeScale shortest_time_scale(const Scene& scene, const nmbc::Lattice& lattice) {
    std::vector<TimeScale> scales{{std::numeric_limits<double>::infinity(), ""}};
    if (scene.drive) {
        scales.push_back({scene.drive->duration, "drive.duration"});
    }
    const auto add = [&](const std::string& group, const ForceHistory& force) {
        if (force.history == History::sine) {
            scales.push_back({1 / force.frequency, "the period of " + group + ".frequency"});
        } else if (force.history != History::file) {
            scales.push_back({force.duration, group + ".duration"});
        }
    };
    if (scene.force) {
        add("force", *scene.force);
    }
    if (scene.left.value) {
        add("boundary.left.value", *scene.left.value);
    }
    if (scene.right.value) {
        add("boundary.right.value", *scene.right.value);
    }
    if (scene.incoming) {
        const Pulse& pulse = scene.incoming->pulse;
        const double c = wave_speed(scene);
        scales.push_back({pulse.width / c, "incoming.width / c"});
        const double square = nmbc::omega_squared(lattice, pulse.wave_number);
        if (pulse.shape == Shape::packet && square > 0) {
            const double omega = std::sqrt(square) * c / scene.spacing;
            scales.push_back({2 * std::numbers::pi / omega, "the period of incoming.wave_number"});
        }
    }
    return *std::ranges::min_element(scales, {}, &TimeScale::time);
}

}  // namespace nmbcrun
