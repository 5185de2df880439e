// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/option_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <numbers>
#include <stdexcept>

#include "generator/cli/comma_list.hpp"
#include "generator/cli/whole_number.hpp"
#include "generator/commands/matching_search.hpp"
#include "generator/exact/rational.hpp"
#include "generator/families/family.hpp"
#include "generator/families/vector_family.hpp"
#include "generator/matching/real.hpp"

namespace nmbcgen {
namespace {

/// 0, 6/5, 1.2, pi/3, 2pi/3, 0.4pi
MatchingPoint parse_point(const std::string& text) {
    const std::size_t letters = text.find("pi");
    MatchingPoint point;
    try {
        if (letters == std::string::npos) {
            point.wave_number = parse_rational(text);
        } else {
            const std::string rest = text.substr(letters + 2);
            if (!rest.empty() && rest.front() != '/') {
                throw std::invalid_argument(rest);
            }
            point.of_pi = true;
            point.wave_number =
                (letters == 0 ? Rational(1) : parse_rational(text.substr(0, letters))) *
                (rest.empty() ? Rational(1) : parse_rational("1" + rest));
        }
    } catch (const std::invalid_argument&) {
        throw std::invalid_argument(
            "'" + text.substr(0, 60) +
            "' is not a wave number such as 6/5, 1.2 or 2pi/3: an integer, a "
            "fraction p/q or a decimal, or one times pi");
    }
    if (wave_number(point) >= pi() || (point.of_pi && point.wave_number == 0)) {
        throw std::invalid_argument("'" + text.substr(0, 60) +
                                    "' is not a wave number from 0 to below pi, in 1/dX");
    }
    return point;
}

/// XI:ROWS
MatchingPoint parse_rows(const std::string& text) {
    const std::size_t colon = text.find(':');
    MatchingPoint point = parse_point(text.substr(0, colon));
    if (colon == std::string::npos) {
        throw std::invalid_argument("'" + text.substr(0, 60) +
                                    "' has no number of rows; give XI:ROWS, such as 0:3 or 1/2:1");
    }
    point.multiplicity = parse_whole_number(text.substr(colon + 1), 2 * highest_count + 1);
    return point;
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
    return parse_whole_number(text, highest_count);
}

unsigned parse_samples(const std::string& text) {
    constexpr unsigned most_samples = 1'000'000;
    return parse_whole_number(text, most_samples);
}

std::string chain_family_names() {
    return names_of(families());
}

std::string plane_family_names() {
    return names_of(vector_families());
}

std::string family_names() {
    return chain_family_names() + ", " + plane_family_names();
}

std::string format_names() {
    return names_of(formats());
}

const Format* parse_format(const std::string& text) {
    return named(formats(), text);
}

std::string influence_names() {
    return names_of(influences());
}

WeightChoice parse_weights(const std::string& text) {
    const auto named = std::ranges::find(influences(), text, &Influence::name);
    if (named != influences().end()) {
        return {.named = &*named, .values = {}};
    }
    WeightChoice choice;
    for (const std::string& item : items_of(text)) {
        try {
            choice.values.push_back(parse_signed_rational(item));
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument(std::string(error.what()) +
                                        "; allowed, too: " + influence_names());
        }
        if (choice.values.back() == 0) {
            throw std::invalid_argument("'" + text.substr(0, 60) +
                                        "': every bond needs a weight other than 0");
        }
    }
    return choice;
}

std::vector<Rational> weights_at(const WeightChoice& choice, unsigned horizon) {
    if (choice.named != nullptr) {
        return normalised(weights_of(*choice.named, horizon));
    }
    if (choice.values.size() != horizon) {
        throw std::invalid_argument(fmt::format("{} weights, where horizon {} needs {}",
                                                choice.values.size(), horizon, horizon));
    }
    return normalised(choice.values);
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

std::string parse_chain_family(const std::string& text) {
    if (std::ranges::find(families(), text, &Family::name) == families().end()) {
        throw std::invalid_argument(
            "'" + text + "' is not a family of chains; allowed: " + chain_family_names());
    }
    return text;
}

std::string parse_plane_family(const std::string& text) {
    if (vector_family(text) == nullptr) {
        throw std::invalid_argument("'" + text +
                                    "' is not a plane family; allowed: " + plane_family_names());
    }
    return text;
}

std::string parse_family(const std::string& text) {
    if (vector_family(text) == nullptr &&
        std::ranges::find(families(), text, &Family::name) == families().end()) {
        throw std::invalid_argument("'" + text + "' is not a family; allowed: " + family_names());
    }
    return text;
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

Matching parse_matching(const std::string& text) {
    Matching matching{.order = 0, .points = {}};
    unsigned rows_at_zero = 0;
    for (const MatchingPoint& point : parse_list(text, parse_rows)) {
        if (point.wave_number != 0) {
            matching.order += point.multiplicity;
            matching.points.push_back(point);
        } else if (rows_at_zero != 0 || point.multiplicity % 2 == 0) {
            throw std::invalid_argument("'" + text.substr(0, 60) +
                                        "': xi = 0 has an odd number of rows, and is given once");
        } else {
            rows_at_zero = point.multiplicity;
        }
    }
    if (rows_at_zero == 0) {
        throw std::invalid_argument("'" + text.substr(0, 60) +
                                    "' needs 0:1 at least, so that a rigid motion is left alone");
    }
    matching.order += (rows_at_zero - 1) / 2;
    if (matching.order < 1 || matching.order > highest_count) {
        throw std::invalid_argument(
            fmt::format("'{}' makes the order {}; allowed are 1 to {}: (rows at 0 - 1)/2 and the "
                        "rows of the others",
                        text.substr(0, 60), matching.order, highest_count));
    }
    std::ranges::sort(matching.points, {}, wave_number);
    const auto twice = std::ranges::adjacent_find(matching.points, {}, wave_number);
    if (twice != matching.points.end()) {
        throw std::invalid_argument("a matching point is given twice: " + to_string(*twice));
    }
    return matching;
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

WaveNumberRange parse_band(const std::string& text) {
    const std::size_t dots = text.find("..");
    WaveNumberRange band{};
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

WaveNumberRange parse_wide_band(const std::string& text) {
    const WaveNumberRange band = parse_band(text);
    if (band.high - band.low < narrowest_band) {
        throw std::invalid_argument(
            fmt::format("'{}' is narrower than {:g}/dX", text.substr(0, 60), narrowest_band));
    }
    return band;
}

}  // namespace nmbcgen
