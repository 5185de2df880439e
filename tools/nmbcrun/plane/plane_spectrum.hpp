// SPDX-License-Identifier: MIT
/// What waves the sources of a plane scene send out.
#pragma once

#include <string>
#include <vector>

#include "tools/nmbcrun/plane/plane_simulation.hpp"

namespace nmbcrun {

/// In words: each source that gives an endless lattice more than a tenth of its energy in waves
/// that are much slower or faster than those of the solid, or go backwards. Looked at are the
/// initial field (one that was read from a file as the simulation has it, at any later step nothing
/// is said of it) and the force, but not one of more nodes than waves are short.
std::vector<std::string> warnings_of_short_waves(const PlaneSimulation& simulation);

}  // namespace nmbcrun
