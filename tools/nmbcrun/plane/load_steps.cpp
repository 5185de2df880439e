// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/load_steps.hpp"

#include <cmath>
#include <numbers>

#include "tools/nmbcrun/plane/plane_lattice.hpp"
#include "tools/nmbcrun/sources/force_in_time.hpp"

namespace nmbcrun {
namespace {

/// Of a velocity or displacement [length/time].
double largest_speed(const PlaneLoad& load) {
    const bool is_velocity = load.given == Given::velocity;
    if (!load.file.empty()) {
        const ForceInTime course(
            {.history = History::file, .amplitude = load.amplitude, .file = load.file});
        return is_velocity ? course.peak() : course.steepest_between_rows();
    }
    if (is_velocity) {
        return std::abs(load.amplitude);
    }
    return load.rise > 0 ? std::abs(load.amplitude) / load.rise : 0;
}

}  // namespace

std::vector<LoadStep> steps_of_loads(const PlaneScene& scene) {
    std::vector<LoadStep> steps;
    const auto stretch = critical_stretch(scene);
    if (!stretch) {
        return steps;
    }
    constexpr double part = 0.1;
    const double way = *stretch * scene.spacing;
    const auto add_speed = [&](const std::string& table, double speed) {
        if (speed > 0) {
            steps.push_back({table, false, way / speed, part * way / speed});
        }
    };
    for (const PlaneLoad& load : scene.loads) {
        if (load.given != Given::force) {
            add_speed(load.name, largest_speed(load));
        } else if (load.rise == 0 && load.file.empty()) {
            const double step = std::sqrt(way * scene.density / std::abs(load.amplitude));
            constexpr double part_of_step = 0.3;  // its square is below that part
            steps.push_back({load.name, true, step, part_of_step * step});
        }
    }
    if (scene.drive) {
        add_speed("drive",
                  std::numbers::pi * std::abs(scene.drive->amplitude) / scene.drive->duration);
    }
    return steps;
}

}  // namespace nmbcrun
