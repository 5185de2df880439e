// SPDX-License-Identifier: MIT
/// The kinds of ends, and their keys.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

const std::vector<std::pair<std::string_view, BoundaryKind>>& boundary_kinds();

/// The keys that count for it, `kind` aside.
std::vector<std::string_view> keys_of(BoundaryKind kind);
bool counts(std::string_view key, BoundaryKind kind);

}  // namespace nmbcrun
