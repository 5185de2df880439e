// SPDX-License-Identifier: MIT
/// Proofs over an interval by subdivision.
#pragma once

#include <algorithm>

#include "generator/enclosures/interval.hpp"

namespace nmbcgen {

/// Whether something holds for all of a range, or for both of its halves, and so on, to a millionth
/// of the range. spread: how far, in parts of itself, what is asked about is unknown anyhow.
template <class Holds>
bool holds_by_halves(const Interval& range, double spread, const Holds& holds) {
    constexpr double millionth = 1e-6;
    const double shortest = millionth * range.upper();
    const double finest = std::max(millionth, spread / 4);
    const auto holds_in = [&](const auto& itself, const Interval& part) -> bool {
        if (holds(part)) {
            return true;
        }
        if (!(width(part) > std::max(shortest, finest * part.upper()))) {
            return false;
        }
        const double middle = median(part);
        return itself(itself, Interval(part.lower(), middle)) &&
               itself(itself, Interval(middle, part.upper()));
    };
    return holds_in(holds_in, range);
}

}  // namespace nmbcgen
