// SPDX-License-Identifier: MIT
/// A strip of a plane lattice, so many layers wide and endless along its two like sides.
#pragma once

#include <cstddef>

#include "generator/plane/side_condition.hpp"

namespace nmbcgen {

/// The largest real part of s [c/dX of the model's units] over all motions exp(s t + i k_t y) of a
/// strip with this many layers between its ghost layers, no fewer than the layers inwards that the
/// condition looks at: positive where it is not stable. Static
/// states have s = 0, up to the roundings of a multiple eigenvalue.
double growth_in_strip(const LateralChain& chain, const SideCondition& condition,
                       std::size_t layers);

/// The largest over wave_numbers equal steps of k_t from 0 to pi.
double largest_growth_in_strip(const PlaneLattice& lattice, const SideCondition& condition,
                               std::size_t layers, std::size_t wave_numbers);

}  // namespace nmbcgen
