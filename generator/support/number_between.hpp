// SPDX-License-Identifier: MIT
/// Numbers on command lines.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <string>
#include <system_error>

namespace nmbcgen {

/// Lets numbers from low to high pass. CLI::Range lets NaN pass, too.
inline CLI::Validator number_between(double low, double high) {
    const auto fault = [low, high](const std::string& text) {
        double value = 0;
        const char* end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        const bool in_range = error == std::errc() && stop == end && low <= value && value <= high;
        return in_range ? std::string()
                        : fmt::format("'{}' is not a number from {:g} to {:g}", text.substr(0, 60),
                                      low, high);
    };
    return {fault, fmt::format("{:g} to {:g}", low, high)};
}

}  // namespace nmbcgen
