// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/duration.hpp"

#include <fmt/format.h>

namespace nmbcrun {

std::string duration(double seconds) {
    constexpr double minute = 60;
    constexpr double hour = 3600;
    if (seconds < 9.95) {
        return fmt::format("{:.2g} s", seconds);
    }
    if (seconds < 2 * minute) {
        return fmt::format("{:.0f} s", seconds);
    }
    return seconds < 2 * hour ? fmt::format("{:.0f} min", seconds / minute)
                              : fmt::format("{:.1f} h", seconds / hour);
}

}  // namespace nmbcrun
