// SPDX-License-Identifier: MIT
/// The boundaries that a chart compares.
#pragma once

#include <string>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// A boundary, to be put at both ends.
struct NamedBoundary {
    std::string name;  ///< short and without commas, such as "NMBC2 s2" or "pml 20"
    Boundary boundary;
};

/// All that can end the scene's lattice, those of one kind in ascending order or width: every table
/// of it, whether it exists at its G or not, that is not matched in time steps, which would
/// prescribe the step, and of the other kinds the widths and orders users take. The scene's own
/// boundaries do not count.
std::vector<NamedBoundary> boundaries_of(const Scene& scene);

/// The scene with the same boundary at both ends, certified or not.
Scene with_ends(Scene scene, const Boundary& boundary);

}  // namespace nmbcrun
