// SPDX-License-Identifier: MIT
/// What is said of the cracks of a plane run.
#pragma once

#include <string>

#include "tools/nmbcrun/plane/plane_files.hpp"
#include "tools/nmbcrun/plane/plane_simulation.hpp"

namespace nmbcrun {

/// Of a scene with fracture, a line each: what has broken; of each end of a crack how far and how
/// fast it has grown, and where it branches. Throws FileError.
std::string crack_report(const PlaneSimulation& simulation, const PlaneFiles& files);

}  // namespace nmbcrun
