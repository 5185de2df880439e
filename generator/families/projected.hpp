// SPDX-License-Identifier: MIT
/// The chain models that waves along an axis see of plane models.
#pragma once

#include "generator/names/projected_family.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// Its energy, description and source. Throws NoSuchModel where there is no such plane model, or
/// its waves of this polarisation make no chain.
Model projected_model(const ProjectedFamily& projected);

/// The nodes along x that a node of the plane model sees, floor(delta/dX).
unsigned horizon_of(const VectorChoice& choice);

}  // namespace nmbcgen
