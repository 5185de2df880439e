// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/option_values.hpp"

#include <fmt/format.h>

#include <charconv>
#include <numbers>
#include <set>
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

/// What `parse` makes of each item of a list with commas.
template <class Value>
std::vector<Value> parse_list(const std::string& text, Value (*parse)(const std::string&)) {
    std::vector<Value> values;
    std::set<Value> seen;
    std::size_t begin = 0;
    std::size_t comma = 0;
    do {
        comma = text.find(',', begin);
        const std::string item = text.substr(begin, comma - begin);
        if (item.empty()) {
            throw std::invalid_argument("'" + text.substr(0, 60) +
                                        "' has an empty item; values go with one comma between");
        }
        values.push_back(parse(item));
        if (!seen.insert(values.back()).second) {
            throw std::invalid_argument("'" + text.substr(0, 60) + "' has the value " + item +
                                        " twice");
        }
        begin = comma + 1;
    } while (comma != std::string::npos);
    return values;
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
    std::string names;
    for (const Family& family : families()) {
        names += (names.empty() ? "" : ", ") + std::string(family.name);
    }
    return names;
}

std::string format_names() {
    std::string names;
    for (const Format& format : formats()) {
        names += (names.empty() ? "" : ", ") + std::string(format.name);
    }
    return names;
}

const Format* parse_format(const std::string& text) {
    for (const Format& format : formats()) {
        if (format.name == text) {
            return &format;
        }
    }
    throw std::invalid_argument("'" + text + "' is not a format; allowed: " + format_names());
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

std::vector<unsigned> parse_counts(const std::string& text) {
    return parse_list(text, parse_count);
}

std::vector<Rational> parse_rationals(const std::string& text) {
    return parse_list<Rational>(text, [](const std::string& item) { return parse_rational(item); });
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
