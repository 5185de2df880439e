// SPDX-License-Identifier: MIT
/// Plane simulations in words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/nmbcrun/plane/plane_simulation.hpp"

namespace nmbcrun {

/// Scene, lattice, sides, whether they are stable, and size, a line each.
std::string heading_of(const PlaneSimulation& simulation);

/// Of strains above 1, which there are now; empty where there are none. when: "at the end".
std::string warning_of_strains(const PlaneSimulation& simulation, std::string_view when);

/// What the user may not expect of such a run, each in one line.
std::vector<std::string> warnings_of(const PlaneSimulation& simulation);

}  // namespace nmbcrun
