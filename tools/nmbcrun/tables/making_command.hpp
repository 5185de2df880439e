// SPDX-License-Identifier: MIT
/// How users get the tables that are not there.
#pragma once

#include <string>
#include <string_view>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Of a family without stabilisation, in words.
std::string why_no_G(std::string_view family, double G);

/// Whether nmbcgen has lattices of this name; tables of a user's own may be of others.
bool is_family(const std::string& name);

/// Why nmbcgen has no lattice of the scene's model, and what is allowed; empty where it has, or
/// where the horizon is beyond its own.
std::string why_no_lattice(const Scene& scene);

/// ". To make it: nmbcgen .., and model.tables = ..", of the table that an end needs, or one with
/// the scene's lattice, which nmbcgen has (why_no_lattice()), where it needs none of its own; empty
/// where a count is beyond those of nmbcgen.
std::string how_to_make(const Scene& scene, const Boundary& boundary);

}  // namespace nmbcrun
