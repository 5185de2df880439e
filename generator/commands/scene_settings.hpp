// SPDX-License-Identifier: GPL-2.0-or-later
/// What of a recommendation a scene of nmbcrun needs.
#pragma once

#include <string>

#include "generator/commands/candidates.hpp"

namespace nmbcgen {

/// Whether its table is in the committed set, in which G stays symbolic.
bool is_committed(const Specification& what);

/// Options of nmbcrun that take the candidate, whose G is fixed, at both ends: "--set KEY=VALUE
/// ..". Of a table that is not committed: as a file in JSON beside the scene.
std::string scene_settings(const Candidate& candidate);

}  // namespace nmbcgen
