// SPDX-License-Identifier: MIT
#include "generator/names/projected_family.hpp"

#include <fmt/format.h>

#include <charconv>
#include <span>
#include <stdexcept>

#include "generator/exact/rational.hpp"
#include "generator/names/names.hpp"

namespace nmbcgen {
namespace {

std::vector<std::string> parts_of(std::string_view name) {
    std::vector<std::string> parts{""};
    for (const char letter : name) {
        if (letter == '_') {
            parts.emplace_back();
        } else {
            parts.back() += letter;
        }
    }
    return parts;
}

std::optional<Rational> value_of(std::string text) {
    const std::size_t mark = text.find('o');
    if (mark == std::string::npos) {
        return std::nullopt;
    }
    text[mark] = '/';
    if (text.front() == 'm') {
        text.front() = '-';
    }
    try {
        return parse_signed_rational(text);
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
}

/// Takes what is between the radius and the polarisation. False where something else is there.
bool take(ProjectedFamily& projected, std::span<const std::string> parts) {
    bool in_weights = false;
    for (const std::string& part : parts) {
        if (in_weights) {
            const auto weight = value_of(part);
            if (!weight) {
                return false;
            }
            projected.model.weights.push_back(*weight);
        } else if (part == "w") {
            in_weights = true;
        } else if (part == "strain") {
            projected.model.plane_strain = true;
        } else if (part.starts_with("nu")) {
            projected.model.poisson = value_of(part.substr(2));
        } else {
            return false;
        }
    }
    return true;
}

}  // namespace

std::string p_over_q(const Rational& value) {
    const Rational size = abs(value);
    return (value < 0 ? "m" : "") + numerator(size).str() + "o" + denominator(size).str();
}

std::string name_of(const ProjectedFamily& projected) {
    std::string name = fmt::format("{}_r{}", projected.family, projected.model.radius_squared);
    if (projected.model.poisson) {
        name += "_nu" + p_over_q(*projected.model.poisson);
    }
    name += projected.model.plane_strain ? "_strain" : "";
    for (std::size_t i = 0; i < projected.model.weights.size(); ++i) {
        name += (i == 0 ? "_w_" : "_") + p_over_q(projected.model.weights[i]);
    }
    return name + (projected.polarisation == Polarisation::P ? "_P" : "_S");
}

std::optional<ProjectedFamily> projected_family(std::string_view name) {
    const std::vector<std::string> parts = parts_of(name);
    if (parts.size() < 3 || !parts[1].starts_with('r') ||
        (parts.back() != "P" && parts.back() != "S")) {
        return std::nullopt;
    }
    ProjectedFamily projected{
        .family = parts[0],
        .polarisation = parts.back() == "P" ? Polarisation::P : Polarisation::S};
    const std::string radius = parts[1].substr(1);
    std::from_chars(radius.data(), radius.data() + radius.size(), projected.model.radius_squared);
    const std::span between(parts.begin() + 2, parts.end() - 1);
    // One model has one name.
    return projected.model.radius_squared <= largest_radius_squared && take(projected, between) &&
                   name_of(projected) == name
               ? std::optional(projected)
               : std::nullopt;
}

std::string options_of(const ProjectedFamily& projected) {
    std::string options =
        fmt::format("--family {} --radius2 {}", projected.family, projected.model.radius_squared);
    if (projected.model.poisson) {
        options += " --nu " + to_string(*projected.model.poisson);
    }
    options += projected.model.plane_strain ? " --state strain" : "";
    for (std::size_t i = 0; i < projected.model.weights.size(); ++i) {
        options += (i == 0 ? " --weights " : ",") + to_string(projected.model.weights[i]);
    }
    return options +
           (projected.polarisation == Polarisation::P ? " --polarisation P" : " --polarisation S");
}

}  // namespace nmbcgen
