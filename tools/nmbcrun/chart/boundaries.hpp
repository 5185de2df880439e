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

/// Whether both ends are physical, and one of them a surface that can be closed in several ways.
bool is_closed(const Scene& scene);

/// All that can end the scene's lattice, those of one kind in ascending order or width: every table
/// of it, whether it exists at its G or not, that is not matched in time steps, which would
/// prescribe the step, and of the other kinds the widths and orders users take. Of a scene that
/// is_closed(): every closure that ends its lattice. The scene's own boundaries do not count.
std::vector<NamedBoundary> boundaries_of(const Scene& scene);

/// The scene with the same boundary at both ends, certified or not, but for physical ends; of one
/// that is_closed(), with all surfaces closed in this way under what is given on them.
Scene with_ends(Scene scene, const Boundary& boundary);

}  // namespace nmbcrun
