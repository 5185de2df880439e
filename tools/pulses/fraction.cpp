// SPDX-License-Identifier: MIT
#include "tools/pulses/fraction.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

namespace pulses {
namespace {

std::optional<double> number(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

}  // namespace

std::optional<double> fraction(std::string_view text) {
    const std::size_t slash = text.find('/');
    const auto numerator = number(text.substr(0, slash));
    const auto denominator =
        slash == std::string_view::npos ? std::optional(1.0) : number(text.substr(slash + 1));
    if (!numerator || !denominator || !(*denominator > 0) ||
        !std::isfinite(*numerator / *denominator)) {
        return std::nullopt;
    }
    return *numerator / *denominator;
}

}  // namespace pulses
