// SPDX-License-Identifier: MIT
/// Values of G worth a look, where a scene leaves it open.
#pragma once

#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// 0, and the G at which the waves of the scene's sources travel with the least error against the
/// wave equation: in the scene's own steps, or in short steps and in those of cfl up to 0.99, where
/// the lattice and the steps make up for each other. To four digits, ascending. Where the family
/// has no stabilisation, 0 alone. The scene's horizon is settled, its G does not count. Throws as
/// Simulation does.
std::vector<double> stabilisations_to_try(const Scene& scene);

}  // namespace nmbcrun
