// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"
#include "generator/families/projected.hpp"
#include "generator/families/vector_family.hpp"
#include "generator/lattice/symbol.hpp"

namespace nmbcgen {

std::span<const Family> families() {
    static constexpr std::array list{
        Family{"nopd1d", nopd1d, nopd1d_moments, nopd1d_limit},
        Family{.name = "bond1d", .describe = bond1d, .has_signed_weights = true},
        Family{"chain1d", chain1d},
    };
    return list;
}

bool is_stabilised(std::string_view family) {
    const auto projected = projected_family(family);
    const VectorFamily* const plane = vector_family(projected ? projected->family : family);
    return plane != nullptr ? plane->has_stabilisation : has_stabilisation(make_model(family, 1));
}

const Family& find_family(std::string_view name) {
    const auto known = families();
    const auto found = std::ranges::find(known, name, &Family::name);
    if (found == known.end()) {
        throw NoSuchModel("there is no family '" + std::string(name) + "'");
    }
    return *found;
}

void damp(Model& model, const Rational& damping) {
    if (damping < 0) {
        throw NoSuchModel("damping has to be 0 or more, not " + to_string(damping));
    }
    if (damping == 0) {
        return;
    }
    std::vector<ExactSquare> at_unit_weight;  // the stabilisation at G = 1
    for (const ExactSquare& square : model.energy) {
        if (square.part == EnergyPart::stabilisation) {
            at_unit_weight.push_back(
                {square.part, constant(evaluate(square.weight, 1)), square.stencil});
        }
    }
    if (at_unit_weight.empty()) {
        throw NoSuchModel("damping " + to_string(damping) +
                          ": this model has no stabilisation to be damped by");
    }
    for (const Polynomial& coefficient : symbol_of(at_unit_weight)) {
        model.damping.push_back(damping * evaluate(coefficient, 0));
    }
    model.description += ", damping tau = " + to_string(damping);
    model.source += "; damping: not in the paper";
}

Model make_model(std::string_view family, unsigned horizon, const Rational& damping,
                 std::span<const Rational> weights) {
    const std::vector<Rational> ones(horizon, Rational(1));
    if (weights.empty()) {
        weights = ones;
    }
    const auto projected = projected_family(family);
    const bool may_be_negative = !projected && find_family(family).has_signed_weights;
    if (weights.size() != horizon || std::ranges::any_of(weights, [&](const Rational& weight) {
            return weight == 0 || (weight < 0 && !may_be_negative);
        })) {
        throw NoSuchModel(
            fmt::format("horizon {} has bonds of {} lengths: as many weights are needed, {}",
                        horizon, horizon, may_be_negative ? "none of them 0" : "all positive"));
    }
    const bool constant_influence =
        std::ranges::count(weights, weights[0]) == std::ptrdiff_t(horizon);
    if (projected && (horizon != horizon_of(projected->model) || !constant_influence)) {
        throw NoSuchModel(fmt::format("{} has horizon {} and weights of its own", family,
                                      horizon_of(projected->model)));
    }
    Model model =
        projected ? projected_model(*projected) : find_family(family).describe(horizon, weights);
    if (!constant_influence) {
        std::string list;
        for (const Rational& weight : weights) {
            list += (list.empty() ? "" : ", ") + to_string(weight);
        }
        model.description += ", influence " + list;
    }
    model.symbol = symbol_of(model.energy);
    const bool has_bonds_below_0 =
        std::ranges::any_of(weights, [](const Rational& weight) { return weight < 0; }) ||
        (projected && std::ranges::any_of(projected->model.weights,
                                          [](const Rational& weight) { return weight < 0; }));
    if (has_bonds_below_0 && !is_positive(model.symbol)) {
        throw NoSuchModel(
            "with these weights the lattice has waves that grow: omega^2 is not "
            "above 0 for all 0 < xi <= pi");
    }
    damp(model, damping);
    return model;
}

}  // namespace nmbcgen
