// SPDX-License-Identifier: MIT
/// The table of a scene's end among the committed ones.
#pragma once

#include <nmbc/lattice.hpp>
#include <nmbc/table.hpp>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// The table of an end with the scene's lattice, damping included. For a fixed or free one, any
/// with this lattice will do. Throws SceneError, which lists the tables of this family and horizon
/// or says which there are, where there is none, and where the scene has a G and the family has no
/// stabilisation. Throws it, too, where the scene's horizon or G is "auto".
const nmbc::MatchingTable& table_of(const Scene& scene, const Boundary& boundary);

/// The horizons that there is a lattice of the scene's family and damping with, ascending.
std::vector<int> horizons_of(const Scene& scene);

/// Every table of the scene's lattice, damping included, whether it exists at the scene's G or not.
std::vector<const nmbc::MatchingTable*> tables_of(const Scene& scene);

/// The scene's lattice. Throws as table_of().
nmbc::Lattice lattice_of(const Scene& scene);

}  // namespace nmbcrun
