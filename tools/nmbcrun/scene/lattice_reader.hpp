// SPDX-License-Identifier: MIT
/// One lattice of a JSON file (docs/reference/json.md).
#pragma once

#include "generator/table/table.hpp"
#include "tools/nmbcrun/scene/json_value.hpp"
#include "tools/nmbcrun/scene/table_file.hpp"

namespace nmbcrun {

struct OwnLattice {
    nmbcgen::Specification what;  ///< family, horizon, influence and damping
    const nmbc::LatticeTable* table = nullptr;
};

/// The table is kept in the storage. Throws SceneError as TableFile has it.
OwnLattice read_lattice(const JsonValue& json, TableStorage& storage);

}  // namespace nmbcrun
