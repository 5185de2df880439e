// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen influence: bonds whose strength falls as a power of their length.
#pragma once

#include <string>

#include "generator/families/power_influence.hpp"

namespace nmbcgen {

/// What the influence does to waves, and its chain: for people, or JSON (docs/reference/json.md).
std::string power_influence_text(const PowerInfluence& influence);
std::string power_influence_json(const PowerInfluence& influence);

}  // namespace nmbcgen
