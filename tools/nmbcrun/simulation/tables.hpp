// SPDX-License-Identifier: MIT
/// The table of a scene's end among the committed ones.
#pragma once

#include <nmbc/lattice.hpp>
#include <nmbc/table.hpp>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// The table of an end with the scene's lattice, damping included. For a fixed or free one, any
/// with this lattice will do. Throws SceneError, which lists the tables of this family and horizon
/// or says which there are, where there is none, and where the scene has a G and the family has no
/// stabilisation.
const nmbc::MatchingTable& table_of(const Scene& scene, const Boundary& boundary);

/// The scene's lattice. Throws as above.
nmbc::Lattice lattice_of(const Scene& scene);

}  // namespace nmbcrun
