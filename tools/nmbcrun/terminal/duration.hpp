// SPDX-License-Identifier: MIT
/// How long something takes, in words.
#pragma once

#include <string>

namespace nmbcrun {

/// To two digits or to whole ones: "0.38 s", "12 s", "110 s", "4 min", "2.5 h", "12 days", "4
/// years".
std::string duration(double seconds);

}  // namespace nmbcrun
