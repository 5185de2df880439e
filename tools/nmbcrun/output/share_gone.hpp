// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>

namespace nmbcrun {

/// Of the energy that went out through an end or side, over the peak.
inline std::string share_gone(double out) {
    constexpr double roundings = 1e-9;
    return fmt::format("{:.3e}{}", out, out < -roundings ? " (energy came in)" : "");
}

}  // namespace nmbcrun
