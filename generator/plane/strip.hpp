// SPDX-License-Identifier: MIT
/// A strip of a plane lattice, so many layers wide and endless along its two like sides.
#pragma once

#include <cstddef>

#include "generator/plane/side_condition.hpp"

namespace nmbcgen {

/// The largest real part of s [c/dX of the model's units] over all motions exp(s t + i k_t y) of a
/// strip with this many layers between its ghost layers: positive where it is not stable. Static
/// states have s = 0, up to the roundings of a multiple eigenvalue.
double growth_in_strip(const LateralChain& chain, const SideCondition& condition,
                       std::size_t layers);

/// The largest of wave numbers along the side, with the wave number that has it.
struct StripGrowth {
    double growth = 0;
    double wave_number = 0;  ///< k_t [1/dX]
};

/// Over wave_numbers equal steps of k_t from 0 to pi.
StripGrowth largest_growth_in_strip(const PlaneLattice& lattice, const SideCondition& condition,
                                    std::size_t layers, std::size_t wave_numbers);

}  // namespace nmbcgen
