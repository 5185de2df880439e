// SPDX-License-Identifier: MIT
#include "generator/exact/rounded_text.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace nmbcgen {
namespace {

std::string nearest_text(double value, int digits) {
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::general, digits);
    return {text.data(), end.ptr};
}

/// One of the last digit, of which the text has so many.
double last_digit(double value, int digits) {
    return std::pow(10, std::floor(std::log10(value)) - digits + 1);
}

}  // namespace

std::string rounded_down(double value, int digits) {
    std::string nearest = nearest_text(value, digits);
    const double shown = std::stod(nearest);
    return shown > value ? nearest_text(shown - last_digit(value, digits), digits) : nearest;
}

std::string rounded_up(double value, int digits) {
    std::string nearest = nearest_text(value, digits);
    const double shown = std::stod(nearest);
    return shown < value ? nearest_text(shown + last_digit(value, digits), digits) : nearest;
}

}  // namespace nmbcgen
