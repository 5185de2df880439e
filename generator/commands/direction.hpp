// SPDX-License-Identifier: GPL-2.0-or-later
/// Directions of the plane whose cosine has a rational square.
#pragma once

#include <string>

#include "generator/table/exact.hpp"

namespace nmbcgen {

struct Direction {
    Rational cosine_squared = 1;  ///< of the angle from the x axis
    std::string text;             ///< as on the command line: degrees, or X:Y
};

}  // namespace nmbcgen
