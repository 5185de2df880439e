// SPDX-License-Identifier: MIT
/// Values of G worth a look, where a scene leaves it open.
#pragma once

#include <vector>

#include "tools/nmbcrun/advise/pause.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// A value of G, and the steps in which lattice and time step make up for each other there.
struct Stabilisation {
    double G = 0;
    double cfl = 0;  ///< 0: none, as in continuous time
};

/// 0, and the G at which the waves of the scene's sources travel with the least error against the
/// wave equation: in the scene's own steps or, where it gives none, in short ones, in some up to
/// cfl = 0.99, and in the longest that a table is certified for at just that G. To four digits, by
/// ascending G. Where the family has no stabilisation, 0 alone. The scene's horizon is settled, its
/// G does not count. Throws as Simulation does.
std::vector<Stabilisation> stabilisations_to_try(const Scene& scene, const Pause& pause);

}  // namespace nmbcrun
