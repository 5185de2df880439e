// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace nmbcrun {

/// The next number of two digits from a value above 0 on, or down from it.
inline double two_digits(double value, bool down) {
    const double digit = std::pow(10, std::floor(std::log10(value)) - 1);
    return digit * (down ? std::floor(value / digit) : std::ceil(value / digit));
}

}  // namespace nmbcrun
