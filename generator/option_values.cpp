// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/option_values.hpp"

#include <fmt/format.h>

#include <charconv>
#include <numbers>
#include <stdexcept>

#include "generator/exact/rational.hpp"
#include "generator/families/family.hpp"

namespace nmbcgen {
namespace {

unsigned parse_whole_number(const std::string& text, unsigned highest) {
    unsigned value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end || value < 1 || value > highest ||
        text.front() == '0') {
        throw std::invalid_argument(
            fmt::format("'{}' is not a whole number from 1 to {} (no leading zeros)",
                        text.substr(0, 60), highest));
    }
    return value;
}

/// The names of a list, with commas between.
template <class Item>
std::string names_of(std::span<const Item> list) {
    std::string names;
    for (const Item& item : list) {
        names += (names.empty() ? "" : ", ") + std::string(item.name);
    }
    return names;
}

template <class SomeFormat>
const SomeFormat* named(std::span<const SomeFormat> list, const std::string& text) {
    for (const SomeFormat& format : list) {
        if (format.name == text) {
            return &format;
        }
    }
    throw std::invalid_argument("'" + text + "' is not a format; allowed: " + names_of(list));
}

}  // namespace

unsigned parse_count(const std::string& text) {
    constexpr unsigned highest_count = 99;
    return parse_whole_number(text, highest_count);
}

unsigned parse_samples(const std::string& text) {
    constexpr unsigned most_samples = 1'000'000;
    return parse_whole_number(text, most_samples);
}

std::string family_names() {
    return names_of(families());
}

std::string format_names() {
    return names_of(formats());
}

const Format* parse_format(const std::string& text) {
    return named(formats(), text);
}

std::string closed_format_names() {
    return names_of(closed_formats());
}

const ClosedFormat* parse_closed_format(const std::string& text) {
    return named(closed_formats(), text);
}

unsigned parse_closed_order(const std::string& text) {
    constexpr unsigned highest_order = 12;
    return parse_whole_number(text, highest_order);
}

std::string parse_family(const std::string& text) {
    for (const Family& family : families()) {
        if (family.name == text) {
            return text;
        }
    }
    throw std::invalid_argument("'" + text + "' is not a family; allowed: " + family_names());
}

std::string parse_folder(const std::string& text) {
    if (text.empty()) {
        throw std::invalid_argument("a folder is needed");
    }
    return text;
}

Rational parse_cfl(const std::string& text) {
    Rational value = parse_rational(text);
    const Rational limit = 1;
    if (value == 0 || value >= limit) {
        throw std::invalid_argument("'" + text.substr(0, 60) +
                                    "' is not between 0 and 1, where leapfrog is stable");
    }
    return value;
}

unsigned parse_recommended_order(const std::string& text) {
    constexpr unsigned highest_order = 8;
    return parse_whole_number(text, highest_order);
}

double parse_fraction(const std::string& text) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end || !(value > 0) || !(value < 1)) {
        throw std::invalid_argument("'" + text.substr(0, 60) +
                                    "' is not a number between 0 and 1, such as 1e-4");
    }
    return value;
}

double parse_recommended_cfl(const std::string& text) {
    constexpr double least = 0.01;  // that a table is ever certified for
    const double value = nearest_double(parse_cfl(text));
    if (value < least) {
        throw std::invalid_argument("'" + text.substr(0, 60) + "' is less than 0.01");
    }
    return value;
}

Band parse_band(const std::string& text) {
    const std::size_t dots = text.find("..");
    Band band{};
    const auto read = [](std::string_view part, double& value) {
        const auto [stop, error] = std::from_chars(part.data(), part.data() + part.size(), value);
        return error == std::errc() && stop == part.data() + part.size();
    };
    const std::string_view view = text;
    if (dots == std::string::npos || !read(view.substr(0, dots), band.low) ||
        !read(view.substr(dots + 2), band.high) || !(band.low > 0) || !(band.low < band.high) ||
        !(band.high < std::numbers::pi)) {
        throw std::invalid_argument(
            "'" + text.substr(0, 60) +
            "' is not a band of wave numbers LO..HI in 1/dX, 0 < LO < HI < pi, such as 0.05..0.3");
    }
    return band;
}

}  // namespace nmbcgen
