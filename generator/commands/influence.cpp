// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/influence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "generator/exact/rational.hpp"
#include "generator/families/vector_family.hpp"

namespace nmbcgen {
namespace {

constexpr unsigned orders[] = {1, 3, 5};

std::vector<std::string> weight_texts(const PowerInfluence& influence) {
    std::vector<std::string> texts;
    for (const Rational& weight : power_weights(influence)) {
        texts.push_back(to_string(weight));
    }
    return texts;
}

/// "a + b ln q"; of two parts only those that are not 0.
std::string text_of(const WithLog& number, const PowerInfluence& influence) {
    const std::string ratio = to_string(1 + influence.horizon / influence.smoothing);
    if (number.of_log == 0) {
        return to_string(number.rational);
    }
    return fmt::format("{} + ({}) ln({})", to_string(number.rational), to_string(number.of_log),
                       ratio);
}

/// The longest closed form or list of weights that anybody reads.
constexpr std::size_t readable = 1500;

/// Decimal places of a weight whose exact text an option does not take.
constexpr unsigned decimal_places = maximum_digits - 2;

/// As --weights takes them; none where they are too many to read, or one is too small.
std::optional<std::string> weights_option(const PowerInfluence& influence) {
    std::vector<std::string> texts;
    for (const Rational& weight : power_weights(influence)) {
        std::string& text = texts.emplace_back(to_string(weight));
        if (text.size() > maximum_digits) {
            const Integer scale = boost::multiprecision::pow(Integer(10), decimal_places);
            const Integer rounded = floor(weight * scale + Rational(1, 2));
            if (rounded == 0) {
                return std::nullopt;
            }
            text = rounded.str();
            text.insert(0, std::max(std::size_t(decimal_places) + 1, text.size()) - text.size(),
                        '0');
            text.insert(text.size() - decimal_places, ".");
        }
    }
    std::string option = fmt::format("{}", fmt::join(texts, ","));
    return option.size() > readable ? std::nullopt : std::optional(std::move(option));
}

}  // namespace

std::string power_influence_text(const PowerInfluence& influence) {
    const std::string eps = to_string(influence.smoothing);
    const double modulus = modulus_of_continuum_factor(influence);
    std::string text = fmt::format(
        "influence   (|xi| + eps)^-p, p = {}, eps = {} dX, delta = {} dX: Seleson 2011, GPMB\n"
        "waves       Omega^2 = c^2 k^2 (1 - A_3 (eps k)^2 + A_5 (eps k)^4 - ..)\n\n"
        "n   A_n, solid      A_n, chain      I(p, n) in units of eps^(n+1-p)\n",
        influence.power, eps, influence.horizon);
    for (const unsigned n : orders) {
        const std::string closed = text_of(moment(influence, n), influence);
        text +=
            fmt::format("{}   {:<14.8g}  {:<14.8g}  {}\n", n, dispersion_coefficient(influence, n),
                        nearest_double(chain_dispersion_coefficient(influence, n)),
                        closed.size() > readable ? "a closed form too long to read" : closed);
    }
    constexpr double resolved = 0.01;
    text += fmt::format(
        "\nmodulus     with gamma_p of the solid the chain would have {:.6g} of it{}\n", modulus,
        std::abs(modulus - 1) > resolved
            ? fmt::format(", the speed {:.4g}: the lattice does\n            not resolve the "
                          "influence. The weights below have the solid's modulus in any case",
                          std::sqrt(modulus))
            : "");
    const auto weights = weights_option(influence);
    text += weights ? fmt::format("options     --family bond1d --horizon {} --weights {}\n",
                                  influence.horizon, *weights)
                    : "options     too long to read; bond1d_weights of --format json has them\n";
    return text;
}

std::string power_influence_json(const PowerInfluence& influence) {
    using Json = nlohmann::ordered_json;
    Json moments = Json::array();
    for (const unsigned n : orders) {
        const WithLog exact = moment(influence, n);
        moments.push_back({{"n", n},
                           {"rational", to_string(exact.rational)},
                           {"of_log", to_string(exact.of_log)},
                           {"solid", dispersion_coefficient(influence, n)},
                           {"chain", nearest_double(chain_dispersion_coefficient(influence, n))}});
    }
    const Json all{{"influence", "power"},
                   {"power", influence.power},
                   {"smoothing", to_string(influence.smoothing)},
                   {"horizon", influence.horizon},
                   {"log_of", to_string(1 + influence.horizon / influence.smoothing)},
                   {"moments", moments},
                   {"modulus_of_continuum_factor", modulus_of_continuum_factor(influence)},
                   {"bond1d_weights", weight_texts(influence)}};
    return all.dump(2) + "\n";
}

namespace {

/// Both families and their weights.
struct ClassOptions {
    std::vector<Offset> classes;
    std::vector<std::string> influence;
    std::vector<std::string> springs;
};

ClassOptions options_of(const ClassInfluence& influence) {
    ClassOptions options{.classes = bond_classes(influence.radius_squared, influence.dimensions),
                         .influence = {},
                         .springs = {}};
    const ClassWeights weights =
        class_weights(influence.power, influence.smoothing, options.classes);
    for (std::size_t a = 0; a < options.classes.size(); ++a) {
        options.influence.push_back(to_string(weights.influence[a]));
        options.springs.push_back(to_string(weights.springs[a]));
    }
    return options;
}

}  // namespace

std::string class_influence_text(const ClassInfluence& influence) {
    const ClassOptions options = options_of(influence);
    const bool in_plane = influence.dimensions == 2;
    const auto lattice = [&](const char* family, const char* poisson,
                             const std::vector<std::string>& weights) {
        return fmt::format("--family {}{}d --radius2 {}{} --weights {}\n", family,
                           influence.dimensions, influence.radius_squared, poisson,
                           fmt::join(weights, ","));
    };
    const unsigned largest =
        find_vector_family(in_plane ? "lps2d" : "lps3d").largest_radius_squared;
    const std::string solid =
        largest > 0 && influence.radius_squared > largest
            ? fmt::format("(lps3d takes family radii up to {}, squared)\n", largest)
            // Poisson's ratio of the bonds, in plane stress
            : lattice("lps", in_plane ? " --nu 1/3" : " --nu 1/4", options.influence);
    return fmt::format(
        "influence   (|xi| + eps)^-p, p = {}, eps = {} dX, delta^2 = {} dX^2: Seleson 2011, GPMB\n"
        "classes     {}, rounded to 1e-12\n"
        "options     {}            {}",
        influence.power, to_string(influence.smoothing), influence.radius_squared,
        options.classes.size(), solid, lattice("bond", "", options.springs));
}

std::string class_influence_json(const ClassInfluence& influence) {
    using Json = nlohmann::ordered_json;
    const ClassOptions options = options_of(influence);
    Json classes = Json::array();
    for (const auto& [i, j, k] : options.classes) {
        classes.push_back(influence.dimensions == 2 ? Json{i, j} : Json{i, j, k});
    }
    const Json all{{"influence", "power"},
                   {"power", influence.power},
                   {"smoothing", to_string(influence.smoothing)},
                   {"dimension", influence.dimensions},
                   {"radius2", influence.radius_squared},
                   {"classes", classes},
                   {"lps_weights", options.influence},
                   {"bond_weights", options.springs}};
    return all.dump(2) + "\n";
}

}  // namespace nmbcgen
