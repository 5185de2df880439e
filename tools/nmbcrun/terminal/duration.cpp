// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/terminal/duration.hpp"

#include <fmt/format.h>

namespace nmbcrun {

std::string duration(double seconds) {
    constexpr double minute = 60;
    constexpr double hour = 3600;
    constexpr double day = 24 * hour;
    constexpr double year = 365 * day;
    if (seconds < 9.95) {
        return fmt::format("{:.2g} s", seconds);
    }
    if (seconds < 2 * minute) {
        return fmt::format("{:.0f} s", seconds);
    }
    if (seconds < 2 * hour) {
        return fmt::format("{:.0f} min", seconds / minute);
    }
    if (seconds < 2 * day) {
        return fmt::format("{:.1f} h", seconds / hour);
    }
    return seconds < year ? fmt::format("{:.0f} days", seconds / day)
                          : fmt::format("{:.2g} years", seconds / year);
}

}  // namespace nmbcrun
