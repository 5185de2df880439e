// SPDX-License-Identifier: MIT
/// Plane simulations in words.
#pragma once

#include <string>

#include "tools/nmbcrun/plane/plane_simulation.hpp"

namespace nmbcrun {

/// Scene, lattice, sides and size, a line each.
std::string heading_of(const PlaneSimulation& simulation);

/// A step and what limits it.
std::string heading_of(const PlanePlan& plan);

/// On stderr, what its time steps miss of its sources; nothing where they do not.
void print_warning(const PlaneSimulation& simulation);

}  // namespace nmbcrun
