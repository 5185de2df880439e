// SPDX-License-Identifier: MIT
/// Where an enclosed polynomial has its zeros between -1 and 1.
#pragma once

#include <optional>

#include "generator/enclosures/interval.hpp"

namespace nmbcgen {

/// Zeros that are not told apart, multiple ones counted as many.
struct ZeroCluster {
    Interval where;
    std::vector<int> counts;  ///< how many there may be, ascending; not {0}
};

/// Disjoint, ascending; every zero in [-1, 1] of every polynomial in the enclosure is in one of
/// them. A polynomial that is <= 0 at 1 is assumed, as omega^2 - Z is for Z >= 0. Nothing where
/// three or more zeros come too close to each other.
std::optional<std::vector<ZeroCluster>> real_zeros(const Expansion& polynomial);

}  // namespace nmbcgen
