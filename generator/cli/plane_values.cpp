// SPDX-License-Identifier: GPL-2.0-or-later
/// The values of options of plane families.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "generator/cli/comma_list.hpp"
#include "generator/cli/option_values.hpp"
#include "generator/cli/whole_number.hpp"
#include "generator/exact/rational.hpp"

namespace nmbcgen {

unsigned parse_radius_squared(const std::string& text) {
    return parse_whole_number(text, largest_radius_squared);
}

namespace {

std::optional<double> number_of(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_number = error == std::errc() && end == text.data() + text.size();
    return is_number ? std::optional(value) : std::nullopt;
}

}  // namespace

bool parse_plane_state(const std::string& text) {
    if (text != "stress" && text != "strain") {
        throw std::invalid_argument("'" + text + "' is not a plane state; allowed: stress, strain");
    }
    return text == "strain";
}

Polarisation parse_polarisation(const std::string& text) {
    if (text != "P" && text != "S") {
        throw std::invalid_argument("'" + text + "' is not a polarisation; allowed: P, S");
    }
    return text == "P" ? Polarisation::P : Polarisation::S;
}

namespace {

double parse_angle(const std::string& text) {
    constexpr double half_turn = 180;
    const std::optional<double> angle = number_of(text);
    if (!angle || !(std::abs(*angle) <= half_turn)) {
        throw std::invalid_argument("'" + text.substr(0, 60) +
                                    "' is not an angle from -180 to 180 degrees");
    }
    return *angle;
}

/// FROM..TO/STEP; of other texts nothing.
std::optional<std::vector<double>> angle_range(const std::string& text) {
    const std::size_t dots = text.find("..");
    const std::size_t slash = text.find('/');
    if (dots == std::string::npos || slash == std::string::npos || slash < dots) {
        return std::nullopt;
    }
    const double from = parse_angle(text.substr(0, dots));
    const double to = parse_angle(text.substr(dots + 2, slash - dots - 2));
    const std::optional<double> step = number_of(text.substr(slash + 1));
    constexpr double least = 0.5;  // a thousand rays at most
    if (!(from < to) || !step || !(*step >= least)) {
        throw std::invalid_argument(
            "'" + text.substr(0, 60) +
            "' is no range such as 0..90/5: FROM below TO, steps of 0.5 degrees or more");
    }
    std::vector<double> angles;
    constexpr double roundings = 1e-9;
    for (unsigned i = 0; from + i * *step <= to + roundings; ++i) {
        angles.push_back(from + i * *step);
    }
    return angles;
}

}  // namespace

std::vector<double> parse_angles(const std::string& text) {
    const auto range = angle_range(text);
    return range ? *range : parse_list<double>(text, parse_angle);
}

namespace {

/// degrees: those to name where the text is no direction.
Direction exact_direction(const std::string& text, std::string_view degrees) {
    static const std::map<std::string, Rational> exact{{"0", 1},
                                                       {"30", Rational(3, 4)},
                                                       {"45", Rational(1, 2)},
                                                       {"60", Rational(1, 4)},
                                                       {"90", 0}};
    if (const auto known = exact.find(text); known != exact.end()) {
        return {.cosine_squared = known->second, .text = text};
    }
    const std::size_t colon = text.find(':');
    constexpr unsigned largest = 1000;
    if (colon == std::string::npos) {
        throw std::invalid_argument(
            fmt::format("'{}' is no direction with an exact cosine: {} degrees, or X:Y of whole "
                        "numbers, such as 10:7 for 35 degrees nearly",
                        text.substr(0, 60), degrees));
    }
    const Rational x = parse_whole_number(text.substr(0, colon), largest, 0);
    const Rational y = parse_whole_number(text.substr(colon + 1), largest, 0);
    if (x == 0 && y == 0) {
        throw std::invalid_argument("0:0 is no direction");
    }
    return {.cosine_squared = x * x / (x * x + y * y), .text = text};
}

/// Of one or two waves POLARISATION:DIRECTION; direction_of() makes what is behind the colon.
template <class Wave, class DirectionOf>
std::vector<Wave> parse_waves(const std::string& text, DirectionOf direction_of) {
    std::vector<Wave> waves;
    for (const std::string& item : items_of(text)) {
        const bool is_wave =
            item.size() > 2 && item[1] == ':' && (item.front() == 'P' || item.front() == 'S');
        if (!is_wave) {
            throw std::invalid_argument("'" + item.substr(0, 60) +
                                        "' is no wave such as P:0, S:45 or S:3:4");
        }
        waves.push_back({parse_polarisation(item.substr(0, 1)), direction_of(item.substr(2))});
    }
    if (waves.size() > 2) {
        throw std::invalid_argument("one or two waves are allowed");
    }
    return waves;
}

[[noreturn]] void refuse_along_the_side(const std::string& direction) {
    throw std::invalid_argument("'" + direction.substr(0, 60) +
                                "' goes along the side: an angle below 90 degrees is needed");
}

double degrees_of(const Direction& direction) {
    const double square = nearest_double(direction.cosine_squared);
    return std::atan2(std::sqrt(1 - square), std::sqrt(square)) * 180 / std::numbers::pi;
}

}  // namespace

Direction parse_direction(const std::string& text) {
    return exact_direction(text, "0, 30, 45, 60 or 90");
}

std::vector<ObliqueWave> parse_oblique_waves(const std::string& text) {
    return parse_waves<ObliqueWave>(text, [](const std::string& one) {
        Direction direction = exact_direction(one, "0, 30, 45 or 60");
        if (direction.cosine_squared == 0) {
            refuse_along_the_side(one);
        }
        return direction;
    });
}

std::vector<AbsorbedWave> parse_absorbed(const std::string& text) {
    return parse_waves<AbsorbedWave>(text, [](const std::string& one) {
        constexpr double grazing = 90;
        const bool is_ratio = one.find(':') != std::string::npos;
        const std::optional<double> angle =
            is_ratio ? degrees_of(parse_direction(one)) : number_of(one);
        if (!angle || !(*angle >= 0)) {
            throw std::invalid_argument("'" + one.substr(0, 60) +
                                        "' is no angle from the normal: degrees, or X:Y");
        }
        if (*angle >= grazing) {
            refuse_along_the_side(one);
        }
        return *angle;
    });
}

}  // namespace nmbcgen
