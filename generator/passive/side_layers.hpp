// SPDX-License-Identifier: MIT
/// How many layers a passive side of a plane may have.
#pragma once

#include <cstddef>

#include "generator/table/vector_model.hpp"

namespace nmbcgen {

/// As many as reach all forces that are cut.
std::size_t least_side_layers(const VectorChoice& choice);

/// Throws std::invalid_argument, "..  has 2 to 16 layers, not 1", where there are no sides of so
/// many: fewer do not reach all forces that are cut, more take too long to design.
std::size_t side_layers_checked(const VectorChoice& choice, std::size_t layers);

}  // namespace nmbcgen
