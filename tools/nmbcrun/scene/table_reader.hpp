// SPDX-License-Identifier: MIT
/// One table of a JSON file (docs/reference/json.md).
#pragma once

#include "tools/nmbcrun/scene/lattice_reader.hpp"

namespace nmbcrun {

/// The table of this lattice: views of what it puts into the storage. Throws SceneError as
/// TableFile has it.
OwnTable read_table(const JsonValue& json, OwnLattice lattice, TableStorage& storage);

}  // namespace nmbcrun
