// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>

namespace nmbcrun {

/// What energies that went out are told over.
struct Whole {
    double energy;
    const char* name;
};

/// All that was put in; the peak where that is small beside it, as what was put in has been taken
/// back, or in steps near the longest the total swings.
inline Whole whole_of(double put_in, double peak) {
    constexpr double enough = 0.1;
    return put_in > enough * peak ? Whole{put_in, "all that was put in"} : Whole{peak, "the peak"};
}

/// Of the energy that went out through an end or side, over the whole.
inline std::string share_gone(double out) {
    constexpr double roundings = 1e-9;
    return fmt::format("{:.3e}{}", out, out < -roundings ? " (energy came in)" : "");
}

}  // namespace nmbcrun
