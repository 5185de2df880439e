// SPDX-License-Identifier: MIT
/// One table of a JSON file (docs/json.md).
#pragma once

#include "tools/nmbcrun/scene/json_value.hpp"
#include "tools/nmbcrun/scene/table_file.hpp"

namespace nmbcrun {

/// Views of what it puts into the storage. Throws SceneError as TableFile has it.
OwnTable read_table(const JsonValue& json, TableStorage& storage);

}  // namespace nmbcrun
