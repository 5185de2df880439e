// SPDX-License-Identifier: GPL-2.0-or-later
/// The values of options of plane families.
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "generator/cli/comma_list.hpp"
#include "generator/cli/option_values.hpp"
#include "generator/cli/whole_number.hpp"

namespace nmbcgen {

unsigned parse_radius_squared(const std::string& text) {
    return parse_whole_number(text, largest_radius_squared);
}

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
        double angle = 0;
        const auto [end, error] = std::from_chars(item.data(), item.data() + item.size(), angle);
        if (error != std::errc() || end != item.data() + item.size() ||
            !(std::abs(angle) <= half_turn)) {
            throw std::invalid_argument("'" + item.substr(0, 60) +
                                        "' is not an angle from -180 to 180 degrees");
        }
        return angle;
    });
}

}  // namespace nmbcgen
