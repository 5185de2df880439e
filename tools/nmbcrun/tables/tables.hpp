// SPDX-License-Identifier: MIT
/// The tables of a scene's lattice: the scene's own, and the committed ones.
#pragma once

#include <nmbc/lattice.hpp>
#include <nmbc/table.hpp>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Every table of the scene's lattice at its G: family, horizon, influence and damping. The
/// scene's own come first, and of several that a Boundary cannot tell from each other only the
/// first is there. They last as long as the scene. Throws SceneError where two have different
/// symbols, and where the scene has a G and the family has no stabilisation.
std::vector<const nmbc::MatchingTable*> tables_of(const Scene& scene);

/// The horizons that there is a lattice of the scene's family, influence and damping with,
/// ascending.
std::vector<int> horizons_of(const Scene& scene);

/// The table of an end with the scene's lattice, damping included. For a fixed or free one, any
/// with this lattice will do. Throws SceneError as above; and where there is none, with the tables
/// of this family and horizon, or which there are, and the command that makes it. Throws it, too,
/// where the scene's horizon or G is "auto".
const nmbc::MatchingTable& table_of(const Scene& scene, const Boundary& boundary);

/// Says so where the table of such an end is one of the scene's own that has the order, stride and
/// step of a committed one, and other coefficients; else nothing. Throws as table_of().
std::string in_place_of_committed(const Scene& scene, const Boundary& boundary);

/// The file of the scene's own tables that has this one, where it was written without a
/// certificate; else nullptr.
const TableFile* uncertified_file(const Scene& scene, const nmbc::MatchingTable& table);

/// The scene's lattice. Throws as above.
nmbc::Lattice lattice_of(const Scene& scene);

}  // namespace nmbcrun
