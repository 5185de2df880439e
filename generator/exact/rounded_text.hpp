// SPDX-License-Identifier: MIT
/// Limits as people read them, in a few digits.
#pragma once

#include <string>

namespace nmbcgen {

/// A value above 0 in so many significant digits, as "0.123": rounded down, so that who gives this
/// text as a limit stays below the value.
std::string rounded_down(double value, int digits);

/// Likewise rounded up.
std::string rounded_up(double value, int digits);

}  // namespace nmbcgen
