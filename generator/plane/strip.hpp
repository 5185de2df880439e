// SPDX-License-Identifier: MIT
/// A strip of a plane lattice, so many layers wide and endless along its two like sides.
#pragma once

#include <cstddef>
#include <vector>

#include "generator/plane/side_condition.hpp"

namespace nmbcgen {

/// The largest real part of s [c/dX of the model's units] over all motions exp(s t + i k_t y) of a
/// strip with this many layers between its ghost layers, no fewer than the layers inwards that the
/// condition looks at: positive where it is not stable. Static
/// states have s = 0, up to the roundings of a multiple eigenvalue.
double growth_in_strip(const LateralChain& chain, const SideCondition& condition,
                       std::size_t layers);

/// k_t in so many equal steps from 0 to pi, and the first of them halved up to five times.
std::vector<double> strip_wave_numbers(std::size_t steps);

/// The largest over strip_wave_numbers().
double largest_growth_in_strip(const PlaneLattice& lattice, const SideCondition& condition,
                               std::size_t layers, std::size_t wave_numbers);

}  // namespace nmbcgen
