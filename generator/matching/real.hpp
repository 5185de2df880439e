// SPDX-License-Identifier: GPL-2.0-or-later
/// Matching points in high precision.
#pragma once

#include "generator/exact/real.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// What counts as zero: far above the roundings, far below what means anything.
inline const Real negligible("1e-60");

/// xi [1/dX]
Real wave_number(const MatchingPoint& point);

}  // namespace nmbcgen
