// SPDX-License-Identifier: GPL-2.0-or-later
/// The values of options of plane families.
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "generator/cli/comma_list.hpp"
#include "generator/cli/option_values.hpp"
#include "generator/cli/whole_number.hpp"

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

std::vector<double> parse_angles(const std::string& text) {
    return parse_list<double>(text, [](const std::string& item) {
        constexpr double half_turn = 180;
        const std::optional<double> angle = number_of(item);
        if (!angle || !(std::abs(*angle) <= half_turn)) {
            throw std::invalid_argument("'" + item.substr(0, 60) +
                                        "' is not an angle from -180 to 180 degrees");
        }
        return *angle;
    });
}

std::vector<AbsorbedWave> parse_absorbed(const std::string& text) {
    std::vector<AbsorbedWave> waves;
    for (const std::string& item : items_of(text)) {
        constexpr double grazing = 90;
        const bool has_angle =
            item.size() > 2 && item[1] == ':' && (item.front() == 'P' || item.front() == 'S');
        const std::optional<double> angle = has_angle ? number_of(item.substr(2)) : std::nullopt;
        if (!angle || !(*angle >= 0 && *angle < grazing)) {
            throw std::invalid_argument(
                "'" + item.substr(0, 60) +
                "' is no wave such as P:0 or S:45, degrees from the normal below 90");
        }
        waves.push_back({parse_polarisation(item.substr(0, 1)), *angle});
    }
    if (waves.size() > 2) {
        throw std::invalid_argument("one or two waves are allowed");
    }
    return waves;
}

}  // namespace nmbcgen
