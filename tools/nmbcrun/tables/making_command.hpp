// SPDX-License-Identifier: MIT
/// How users get the tables that are not there.
#pragma once

#include <string>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// ". To make it: nmbcgen .., and model.tables = ..", of the table that an end needs, or one with
/// the scene's lattice where it needs none of its own; empty where nmbcgen has no such lattice.
std::string how_to_make(const Scene& scene, const Boundary& boundary);

}  // namespace nmbcrun
