// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nmbc/coefficients.hpp>
#include <span>
#include <utility>

#include "generator/exact/rational.hpp"
#include "generator/lattice/symbol.hpp"
#include "generator/names/names.hpp"
#include "tools/nmbcrun/scene/exact_json.hpp"

namespace nmbcrun {
namespace {

constexpr int most = 99;  // orders, horizons and strides, as nmbcgen has it
constexpr double highest = std::numeric_limits<double>::max();

nmbcgen::Specification specification_of(const JsonValue& json) {
    nmbcgen::Specification what{.family = json.at("family").text(),
                                .horizon = unsigned(json.at("horizon").whole_number(1, most)),
                                .order = unsigned(json.at("order").whole_number(1, most)),
                                .stride = unsigned(json.at("stride").whole_number(1, most)),
                                .stabilisation = {},
                                .damping = parameter_of(json.at("tau")),
                                .time_step = parameter_of(json.at("time_step"))};
    if (!json.at("G").is_null()) {
        what.stabilisation = parameter_of(json.at("G"));
    }
    if (!json.has("weights")) {
        return what;
    }
    for (const JsonValue& element : json.at("weights").elements()) {
        what.weights.push_back(parameter_of(element));
        if (what.weights.back() == 0) {
            element.must_be("positive");
        }
    }
    const auto is_one = [](const nmbcgen::Rational& weight) { return weight == 1; };
    if (what.weights.size() != what.horizon || !is_one(what.weights.front()) ||
        std::ranges::all_of(what.weights, is_one)) {
        json.at("weights").must_be(
            fmt::format("a list of {}, the first of them \"1\", and left "
                        "out where all of them are",
                        what.horizon));
    }
    return what;
}

/// Whether omega^2 = xi^2 + .. at every G, as dX = c = 1 has it.
bool is_of_unit_speed(const std::vector<nmbcgen::Polynomial>& symbol) {
    nmbcgen::Polynomial at_rest = symbol[0];
    nmbcgen::Polynomial curvature;
    for (std::size_t m = 1; m < symbol.size(); ++m) {
        at_rest += symbol[m] * nmbcgen::Rational(2);
        curvature -= symbol[m] * nmbcgen::Rational(m * m);
    }
    return at_rest.is_zero() && curvature == nmbcgen::Polynomial(std::vector<nmbcgen::Rational>{1});
}

/// Throws where it is none.
nmbcgen::Polynomial polynomial_of(const JsonValue& json, const Fraction& function) {
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

class TableReader {
  public:
    TableReader(const JsonValue& json, TableStorage& storage)
        : json_(json), storage_(storage), what_(specification_of(json)) {}

    OwnTable read();

  private:
    std::string_view keep(std::string text) { return storage_.texts.emplace_back(std::move(text)); }
    Fraction exact(const JsonValue& json) const {
        return what_.stabilisation ? fraction_of(json) : rational_function_of(json);
    }
    nmbc::RationalFunction view(Fraction function) {
        return {keep(std::move(function.numerator)), keep(std::move(function.denominator))};
    }
    std::span<const nmbc::RationalFunction> functions(const char* key, std::size_t size);
    std::span<const nmbc::RationalFunction> symbol();
    std::span<const nmbc::RationalFunction> damping(std::size_t size);
    void require_damping_of_stabilisation(std::size_t size) const;
    std::span<const nmbc::EnergySquare> energy();
    nmbcgen::ExactSquare square(const JsonValue& json, std::size_t reach) const;
    nmbc::EnergySquare view(const JsonValue& json, const nmbcgen::ExactSquare& square);
    std::span<const nmbc::Window> windows(const char* key);
    std::span<const nmbc::StableStep> steps(const char* key);

    const JsonValue& json_;
    TableStorage& storage_;
    nmbcgen::Specification what_;
};

std::span<const nmbc::RationalFunction> TableReader::functions(const char* key, std::size_t size) {
    const JsonValue json = json_.at(key);
    const std::vector<JsonValue> elements = json.elements();
    if (elements.size() != size) {
        json.must_be(fmt::format("a list of {}", size));
    }
    auto& list = storage_.functions.emplace_back();
    list.reserve(size);
    for (const JsonValue& element : elements) {
        list.push_back(view(exact(element)));
    }
    return list;
}

nmbcgen::ExactSquare TableReader::square(const JsonValue& json, std::size_t reach) const {
    const std::string part = json.at("part").text();
    const bool is_strain = part == name_of(nmbcgen::EnergyPart::strain);
    if (!is_strain && part != name_of(nmbcgen::EnergyPart::stabilisation)) {
        json.at("part").must_be(R"("strain" or "stabilisation")");
    }
    const JsonValue weight = json.at("weight");
    nmbcgen::ExactSquare result{
        .part = is_strain ? nmbcgen::EnergyPart::strain : nmbcgen::EnergyPart::stabilisation,
        .weight = polynomial_of(weight, exact(weight)),
        .stencil = {}};
    if (std::ranges::any_of(result.weight.data(), [](const auto& entry) { return entry < 0; })) {
        weight.must_be("not below 0");
    }
    const std::vector<JsonValue> stencil = json.at("stencil").elements();
    if (stencil.size() % 2 == 0 || stencil.size() > 2 * reach + 1) {
        json.at("stencil").must_be(
            fmt::format("a list of an odd number of entries, up to {}", 2 * reach + 1));
    }
    for (const JsonValue& entry : stencil) {
        result.stencil.push_back(fraction_of(entry).value());
    }
    return result;
}

nmbc::EnergySquare TableReader::view(const JsonValue& json, const nmbcgen::ExactSquare& square) {
    nmbcgen::Integer divisor = 1;
    for (const nmbcgen::Rational& entry : square.stencil) {
        divisor = lcm(divisor, denominator(entry));
    }
    std::string stencil;
    for (const nmbcgen::Rational& entry : square.stencil) {
        stencil += (stencil.empty() ? "" : " ") + nmbcgen::to_string(entry * divisor);
    }
    return {square.part, view(exact(json.at("weight"))), keep(std::move(stencil)),
            keep(divisor.str())};
}

std::span<const nmbc::RationalFunction> TableReader::symbol() {
    const JsonValue json = json_.at("symbol");
    const std::size_t size = json.elements().size();
    constexpr std::size_t longest = 2 * most + 1;  // that of nopd1d, of reach 2n
    if (size < 2 || size > longest) {
        json.must_be(fmt::format("a list of 2 to {}", longest));
    }
    return functions("symbol", size);
}

std::span<const nmbc::RationalFunction> TableReader::damping(std::size_t size) {
    const auto numbers = functions("damping", what_.damping > 0 ? size : 0);
    for (const nmbc::RationalFunction& number : numbers) {
        if (number.numerator.find(' ') != std::string_view::npos ||
            number.denominator.find(' ') != std::string_view::npos) {
            json_.at("damping").must_be("a list of numbers, the same at every G");
        }
    }
    return numbers;
}

/// tau times the symbol of the stabilisation at G = 1, to which its weights are proportional.
void TableReader::require_damping_of_stabilisation(std::size_t size) const {
    const nmbcgen::Rational G = what_.stabilisation.value_or(1);
    std::vector<nmbcgen::ExactSquare> squares;
    for (const JsonValue& each : json_.at("energy").elements()) {
        squares.push_back(square(each, size - 1));
    }
    std::erase_if(squares, [](const nmbcgen::ExactSquare& each) {
        return each.part != nmbcgen::EnergyPart::stabilisation;
    });
    std::vector<nmbcgen::Polynomial> sigma(size);
    if (!squares.empty()) {
        std::ranges::copy(symbol_of(squares), sigma.begin());
    }
    const std::vector<JsonValue> stated = json_.at("damping").elements();
    for (std::size_t m = 0; m < size; ++m) {
        const nmbcgen::Polynomial of_m = polynomial_of(stated[m], exact(stated[m]));
        if (of_m.evaluate(1) !=
            sigma[m].evaluate(what_.stabilisation ? 0 : 1) * what_.damping / G) {
            json_.at("damping").must_be("tau times the symbol of the stabilisation at G = 1");
        }
    }
}

/// Of which the symbol is the one in the table.
std::span<const nmbc::EnergySquare> TableReader::energy() {
    const JsonValue symbol = json_.at("symbol");
    std::vector<nmbcgen::Polynomial> stated;
    for (const JsonValue& entry : symbol.elements()) {
        stated.push_back(polynomial_of(entry, exact(entry)));
    }
    std::vector<nmbcgen::ExactSquare> exact_squares;
    auto& squares = storage_.squares.emplace_back();
    for (const JsonValue& each : json_.at("energy").elements()) {
        exact_squares.push_back(square(each, stated.size() - 1));
        squares.push_back(view(each, exact_squares.back()));
    }
    if (exact_squares.empty() || symbol_of(exact_squares) != stated) {
        symbol.must_be("the symbol of \"energy\"");
    }
    if (!is_of_unit_speed(stated)) {
        symbol.must_be("that of omega^2 = xi^2 + ..");
    }
    return squares;
}

std::span<const nmbc::Window> TableReader::windows(const char* key) {
    auto& list = storage_.windows.emplace_back();
    const JsonValue json = json_.at("windows").at(key);
    if (json.is_null()) {  // not sought
        return list;
    }
    for (const JsonValue& window : json.elements()) {
        const std::vector<JsonValue> edges = window.elements();
        if (edges.size() != 2) {
            window.must_be("a list of 2");
        }
        const double low = edges[0].at("value").number(0, highest);
        list.push_back({low, edges[1].is_null() ? nmbc::unbounded
                                                : edges[1].at("value").number(low, highest)});
    }
    return list;
}

std::span<const nmbc::StableStep> TableReader::steps(const char* key) {
    auto& list = storage_.steps.emplace_back();
    for (const JsonValue& piece : json_.at(key).elements()) {
        const double low = piece.at("low").number(0, highest);
        const double high =
            piece.at("high").is_null() ? nmbc::unbounded : piece.at("high").number(low, highest);
        const double cfl = piece.at("cfl").number(0, 1);
        list.push_back({{low, high}, cfl, piece.at("from").number(0, cfl)});
    }
    return list;
}

OwnTable TableReader::read() {
    const auto rational = [&](const nmbcgen::Rational& value) {
        return keep(nmbcgen::to_string(value));
    };
    const std::string matched =
        json_.has("match") ? ", matched at " + json_.at("match").text() : "";
    OwnTable own;
    for (const nmbcgen::Rational& weight : what_.weights) {
        own.weights.push_back(nmbcgen::to_string(weight));
    }
    const auto of_the_lattice = symbol();
    own.table = {
        .name = keep(table_name(what_) + matched),
        .family = keep(what_.family),
        .horizon = int(what_.horizon),
        .order = int(what_.order),
        .stride = int(what_.stride),
        .fixed_G = what_.stabilisation ? rational(*what_.stabilisation) : "",
        .tau = rational(what_.damping),
        .time_step = rational(what_.time_step),
        .source = keep(json_.at("source").text()),
        .proved = keep(json_.at("proved").text()),
        .symbol = of_the_lattice,
        .damping = damping(of_the_lattice.size()),
        .energy = energy(),
        .taylor = functions("taylor", 2 * what_.order + 1),
        .c = functions("c", what_.order + 1),
        .b = functions("b", what_.order + 1),
        .reflection = windows("reflection"),
        .modal = windows("modal"),
        .contractive = windows("contractive"),
        .max_cfl = steps("max_cfl"),
        .max_cfl_contractive = steps("max_cfl_contractive"),
        .least_nodes = json_.at("least_nodes").whole_number(0, std::numeric_limits<int>::max())};
    const nmbc::MatchingTable& table = own.table;
    if (what_.damping > 0 && what_.stabilisation != 0) {  // at G = 0 the squares have lost it
        require_damping_of_stabilisation(table.damping.size());
    }
    if (table.c[0].numerator != "1" || table.c[0].denominator != "1") {
        json_.at("c").must_be("a list that begins with 1");
    }
    own.is_certified = !json_.at("certificate").is_null();
    if (own.is_certified) {
        json_.at("certificate").text();
    } else if (!table.reflection.empty() || !table.modal.empty() || !table.contractive.empty() ||
               !table.max_cfl.empty() || !table.max_cfl_contractive.empty()) {
        json_.at("certificate").must_be("a string where there are windows and steps");
    }
    return own;
}

}  // namespace

OwnTable read_table(const JsonValue& json, TableStorage& storage) {
    return TableReader(json, storage).read();
}

}  // namespace nmbcrun
