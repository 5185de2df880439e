// SPDX-License-Identifier: GPL-2.0-or-later
/// The matching points with which a condition reflects least over a band.
///
/// Points are multiples of the largest power of ten that is no more than a hundredth of the band's
/// width; points that meet are one of their multiplicity. Twice, from the Chebyshev nodes of the
/// band and from those of the wave numbers below it (next to the standard condition, so certified
/// where that is), cyclic coordinate search: each point in turn goes up or down by a step where
/// that lowers the mean reflected energy by a thousandth or more; where none does, the step, a
/// quarter of the band at first, is halved, down to one unit. Then once more from the best
/// certified ones met on the way, to certified ones only. Certified, in this search, is stable in
/// continuous time and in the steps asked for, or in steps of cfl 0.05.
#pragma once

#include <vector>

#include "generator/recommend.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// A mean over a narrower band would be one over next to equal waves.
inline constexpr double narrowest_band = 1e-6;  // [1/dX]

/// Of what is tried with so many points, the best that is certified; where none is, the best.
/// Empty where there is no condition with any of them.
/// lattice: a table at a fixed G with its model and its Taylor coefficients, its specification the
/// one wanted but for the points; count: 1 .. order. Uses no algebra system: threads may share it.
std::vector<MatchingPoint> best_points(const Table& lattice, unsigned count, const Band& band);

}  // namespace nmbcgen
