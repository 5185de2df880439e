// SPDX-License-Identifier: GPL-2.0-or-later
/// The matching points with which a condition reflects least over a band.
///
/// Points are multiples of the largest power of ten that is no more than a hundredth of the band's
/// width; points that meet are one of their multiplicity. For one point, two, and so on up to the
/// order, cyclic coordinate search: each point in turn goes up or down by a step where that lowers
/// the mean reflected energy by a thousandth or more; where none does, the step, a quarter of the
/// band at first, is halved, down to one unit. It starts from
///   - the Chebyshev nodes of the band,
///   - those of the wave numbers below it: next to the standard condition, so certified where that
///     is,
///   - those of as many above it,
///   - the best ones of one point less, with another next to xi = 0, or next to pi,
/// and once more, to certified ones only, from the best certified ones met on the way; there a
/// point also takes another with it, by its step, a half of it, a quarter, .., as the best are
/// often on the edge of what is certified. Certified, in this search, is stable in continuous time
/// and in the steps asked for, or in steps of cfl 0.05.
#pragma once

#include <vector>

#include "generator/commands/recommend.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// A mean over a narrower band would be one over next to equal waves.
inline constexpr double narrowest_band = 1e-6;  // [1/dX]

/// For 1 .. order points, multiple ones counted as many, the best that is certified; where none is,
/// the best; empty where there is no condition with any that were tried.
/// lattice: a table at a fixed G with its model and its Taylor coefficients, its specification the
/// one wanted but for the points. Uses no algebra system: threads may share it.
std::vector<std::vector<MatchingPoint>> best_points(const Table& lattice,
                                                    const WaveNumberRange& band);

}  // namespace nmbcgen
