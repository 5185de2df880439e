// SPDX-License-Identifier: MIT
/// In which time steps the loads of a plane scene may break bonds by their jumps alone.
#pragma once

#include <string>
#include <vector>

#include "tools/nmbcrun/plane/plane_scene.hpp"

namespace nmbcrun {

/// Of a load, or the drive, where bonds may break.
struct LoadStep {
    std::string table{};  ///< as the scene has it, "load.top"
    bool is_force = false;
    double longest = 0;  ///< its nodes move by the critical stretch times dX in one step [time]
    double fine = 0;     ///< by at most a tenth of that
};

/// Of each force without rise, by the first step, and of each velocity, displacement and drive that
/// is not 0, by its largest speed; none where no bonds break. Each load counts by itself: the ends
/// of a bond between nodes of two move by a fifth at most. Throws as ForceInTime.
std::vector<LoadStep> steps_of_loads(const PlaneScene& scene);

}  // namespace nmbcrun
