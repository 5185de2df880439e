// SPDX-License-Identifier: GPL-2.0-or-later
/// Whole numbers on the command line.
#pragma once

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>
#include <string>

namespace nmbcgen {

/// lowest to highest. Throws std::invalid_argument.
inline unsigned parse_whole_number(const std::string& text, unsigned highest, unsigned lowest = 1) {
    unsigned value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end || value < lowest || value > highest ||
        (text.front() == '0' && text.size() > 1)) {
        throw std::invalid_argument(
            fmt::format("'{}' is not a whole number from {} to {} (no leading zeros)",
                        text.substr(0, 60), lowest, highest));
    }
    return value;
}

}  // namespace nmbcgen
