// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/lattice_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nmbc/coefficients.hpp>
#include <utility>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/lattice/symbol.hpp"
#include "generator/names/names.hpp"
#include "tools/nmbcrun/scene/exact_json.hpp"

namespace nmbcrun {
namespace {

constexpr std::size_t longest_symbol = 2 * nmbcgen::highest_count + 1;  // nopd1d's, of reach 2n

std::vector<nmbcgen::Rational> weights_of(const JsonValue& json, unsigned horizon) {
    std::vector<nmbcgen::Rational> weights;
    for (const JsonValue& element : json.elements()) {
        weights.push_back(number_of(element));
        if (weights.back() == 0) {
            element.must_be("another number than 0");
        }
    }
    const auto is_one = [](const nmbcgen::Rational& weight) { return weight == 1; };
    if (weights.size() != horizon || !is_one(abs(weights.front())) ||
        std::ranges::all_of(weights, is_one)) {
        json.must_be(
            fmt::format("a list of {}, the first of them \"1\" or \"-1\", and left "
                        "out where all of them are \"1\"",
                        horizon));
    }
    return weights;
}

/// Family, horizon, influence and damping.
nmbcgen::Specification specification_of(const JsonValue& json) {
    nmbcgen::Specification what{
        .family = json.at("family").text(),
        .horizon = unsigned(json.at("horizon").whole_number(1, nmbcgen::highest_count)),
        .stabilisation = {},
        .damping = parameter_of(json.at("tau"))};
    if (json.has("weights")) {
        what.weights = weights_of(json.at("weights"), what.horizon);
    }
    if (json.at("name").text() != lattice_name(what)) {
        json.at("name").must_be('"' + lattice_name(what) + '"');
    }
    return what;
}

nmbcgen::Polynomial polynomial_of(const JsonValue& json) {
    const Fraction function = rational_function_of(json);
    if (function.denominator.find(' ') != std::string::npos) {
        json.must_be("a polynomial in G: \"den\" a list of one");
    }
    std::vector<nmbcgen::Rational> coefficients;
    nmbc::detail::for_each_integer(
        function.numerator, [&](std::size_t /*power*/, std::string_view integer) {
            coefficients.push_back(Fraction{std::string(integer), function.denominator}.value());
        });
    return nmbcgen::Polynomial(std::move(coefficients));
}

std::vector<nmbcgen::Polynomial> polynomials_of(const JsonValue& json, std::size_t least,
                                                std::size_t most) {
    std::vector<nmbcgen::Polynomial> polynomials;
    for (const JsonValue& element : json.elements()) {
        polynomials.push_back(polynomial_of(element));
    }
    if (polynomials.size() < least || polynomials.size() > most) {
        json.must_be(least == most ? fmt::format("a list of {}", most)
                                   : fmt::format("a list of {} to {}", least, most));
    }
    return polynomials;
}

nmbcgen::ExactSquare square_of(const JsonValue& json, std::size_t reach, bool may_be_negative) {
    const std::string part = json.at("part").text();
    const bool is_strain = part == name_of(nmbc::EnergyPart::strain);
    if (!is_strain && part != name_of(nmbc::EnergyPart::stabilisation)) {
        json.at("part").must_be(R"("strain" or "stabilisation")");
    }
    const JsonValue weight = json.at("weight");
    nmbcgen::ExactSquare square{
        is_strain ? nmbc::EnergyPart::strain : nmbc::EnergyPart::stabilisation,
        polynomial_of(weight),
        {}};
    if (!may_be_negative &&
        std::ranges::any_of(square.weight.data(), [](const auto& entry) { return entry < 0; })) {
        weight.must_be("not below 0");
    }
    const std::vector<JsonValue> stencil = json.at("stencil").elements();
    if (stencil.size() % 2 == 0 || stencil.size() > 2 * reach + 1) {
        json.at("stencil").must_be(
            fmt::format("a list of an odd number of entries, up to {}", 2 * reach + 1));
    }
    for (const JsonValue& entry : stencil) {
        square.stencil.push_back(fraction_of(entry).value());
    }
    return square;
}

/// Whether omega^2 = xi^2 + .. at every G, as dX = c = 1 has it.
bool is_of_unit_speed(const std::vector<nmbcgen::Polynomial>& symbol) {
    nmbcgen::Polynomial at_rest = symbol[0];
    nmbcgen::Polynomial curvature;
    for (std::size_t m = 1; m < symbol.size(); ++m) {
        at_rest += symbol[m] * nmbcgen::Rational(2);
        curvature -= symbol[m] * nmbcgen::Rational(m * m);
    }
    return at_rest.is_zero() && curvature == nmbcgen::constant(1);
}

/// The symbol is that of the energy, and the damping tau times that of the stabilisation at G = 1,
/// to which its weights are proportional.
void require_of_energy(const JsonValue& json, const nmbcgen::Model& model,
                       const nmbcgen::Rational& tau) {
    if (model.energy.empty() || nmbcgen::symbol_of(model.energy) != model.symbol) {
        json.at("symbol").must_be("the symbol of \"energy\"");
    }
    if (!is_of_unit_speed(model.symbol)) {
        json.at("symbol").must_be("that of omega^2 = xi^2 + ..");
    }
    std::vector<nmbcgen::ExactSquare> stabilisation = model.energy;
    std::erase_if(stabilisation, [](const nmbcgen::ExactSquare& square) {
        return square.part != nmbc::EnergyPart::stabilisation;
    });
    std::vector<nmbcgen::Polynomial> sigma(model.symbol.size());
    if (!stabilisation.empty()) {
        std::ranges::copy(nmbcgen::symbol_of(stabilisation), sigma.begin());
    }
    for (std::size_t m = 0; m < model.damping.size(); ++m) {
        if (model.damping[m] != nmbcgen::evaluate(sigma[m], 1) * tau) {
            json.at("damping").must_be("tau times the symbol of the stabilisation at G = 1");
        }
    }
}

/// Bonds below 0 make energies below 0, of which those of waves in the whole lattice are none.
void require_positive(const JsonValue& json, const std::vector<nmbcgen::Polynomial>& symbol) {
    const bool has_G = std::ranges::any_of(
        symbol, [](const nmbcgen::Polynomial& entry) { return entry.size() > 1; });
    if (has_G || !nmbcgen::is_positive(symbol)) {
        json.at("symbol").must_be(
            "above 0 for all 0 < xi <= pi, and without G, where a weight is below 0");
    }
}

nmbcgen::Model model_of(const JsonValue& json, const nmbcgen::Specification& what) {
    nmbcgen::Model model;
    model.symbol = polynomials_of(json.at("symbol"), 2, longest_symbol);
    const nmbcgen::Rational& tau = what.damping;
    const bool may_be_negative = std::ranges::any_of(
        what.weights, [](const nmbcgen::Rational& weight) { return weight < 0; });
    const std::size_t size = tau > 0 ? model.symbol.size() : 0;
    for (const nmbcgen::Polynomial& number : polynomials_of(json.at("damping"), size, size)) {
        if (number.size() > 1) {
            json.at("damping").must_be("a list of numbers, the same at every G");
        }
        model.damping.push_back(nmbcgen::evaluate(number, 0));
    }
    for (const JsonValue& square : json.at("energy").elements()) {
        model.energy.push_back(square_of(square, model.symbol.size() - 1, may_be_negative));
    }
    require_of_energy(json, model, tau);
    if (may_be_negative) {
        require_positive(json, model.symbol);
    }
    return model;
}

nmbc::EnergySquare view(const JsonValue& json, const nmbcgen::ExactSquare& square,
                        TableStorage& storage) {
    nmbcgen::Integer divisor = 1;
    for (const nmbcgen::Rational& entry : square.stencil) {
        divisor = lcm(divisor, denominator(entry));
    }
    std::string stencil;
    for (const nmbcgen::Rational& entry : square.stencil) {
        stencil += (stencil.empty() ? "" : " ") + nmbcgen::to_string(entry * divisor);
    }
    return {square.part, storage.keep(rational_function_of(json.at("weight"))),
            storage.keep(std::move(stencil)), storage.keep(divisor.str())};
}

}  // namespace

OwnLattice read_lattice(const JsonValue& json, TableStorage& storage) {
    const nmbcgen::Specification what = specification_of(json);
    const nmbcgen::Model model = model_of(json, what);
    const auto functions = [&](const char* key) {
        auto& list = storage.functions.emplace_back();
        for (const JsonValue& element : json.at(key).elements()) {
            list.push_back(storage.keep(rational_function_of(element)));
        }
        return std::span<const nmbc::RationalFunction>(list);
    };
    auto& squares = storage.squares.emplace_back();
    for (const JsonValue& each : json.at("energy").elements()) {
        squares.push_back(view(each, model.energy[squares.size()], storage));
    }
    const nmbc::LatticeTable& table = storage.lattices.emplace_back(
        nmbc::LatticeTable{.name = storage.keep(lattice_name(what)),
                           .family = storage.keep(what.family),
                           .horizon = int(what.horizon),
                           .weights = storage.keep(weights_text(what)),
                           .tau = storage.keep(nmbcgen::to_string(what.damping)),
                           .source = storage.keep(json.at("source").text()),
                           .symbol = functions("symbol"),
                           .damping = functions("damping"),
                           .energy = squares});
    return {what, &table};
}

}  // namespace nmbcrun
