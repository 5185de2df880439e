// SPDX-License-Identifier: MIT
/// Proofs over an interval by subdivision.
#pragma once

#include <algorithm>

#include "generator/enclosures/interval.hpp"

namespace nmbcgen {

/// How short the parts become before a proof is given up: `shortest`, or `finest` of their upper
/// end.
struct Subdivision {
    double shortest;
    double finest;
};

/// Whether something holds for all of a range, or for both of its halves, and so on.
template <class Holds>
bool holds_by_halves(const Interval& range, const Subdivision& limits, const Holds& holds) {
    if (holds(range)) {
        return true;
    }
    if (!(width(range) > std::max(limits.shortest, limits.finest * range.upper()))) {
        return false;
    }
    const double middle = median(range);
    return holds_by_halves(Interval(range.lower(), middle), limits, holds) &&
           holds_by_halves(Interval(middle, range.upper()), limits, holds);
}

}  // namespace nmbcgen
