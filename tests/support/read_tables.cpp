// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/support/read_tables.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "generator/emit/certificate_json.hpp"
#include "generator/emit/emit.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"
#include "generator/matching/proof.hpp"
#include "generator/names/names.hpp"
#include "generator/pipeline.hpp"

namespace nmbcgen::test {
namespace {

void require(bool holds, const std::string& statement) {
    if (!holds) {
        throw std::runtime_error("not so: " + statement);
    }
}

Integer read_integer(const std::string& text) {
    const std::string digits = text.starts_with('-') ? text.substr(1) : text;
    require(!digits.empty() &&
                std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; }) &&
                (digits.front() != '0' || text == "0"),
            "'" + text + "' is an integer in normal form");
    return Integer(text);
}

Rational read_rational(const std::string& text) {
    const std::size_t slash = text.find('/');
    const Integer top = read_integer(text.substr(0, slash));
    const Integer bottom =
        slash == std::string::npos ? Integer(1) : read_integer(text.substr(slash + 1));
    require(bottom > 0, "a positive denominator");
    Rational value(top, bottom);
    require(to_string(value) == text, "'" + text + "' is in lowest terms");
    return value;
}

std::vector<Integer> split(std::string_view text) {
    std::vector<Integer> integers;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find(' ', start), text.size());
        integers.push_back(read_integer(std::string(text.substr(start, end - start))));
        start = end + 1;
    }
    return integers;
}

ExactFunction make_function(const std::vector<Integer>& top, const std::vector<Integer>& bottom) {
    for (const auto* list : {&top, &bottom}) {
        require(!list->empty() && (list->size() == 1 || list->back() != 0),
                "the leading coefficient is not zero");
    }
    ExactFunction function{IntegerPolynomial(top), IntegerPolynomial(bottom)};
    require(!function.denominator.is_zero(), "a denominator");
    require(reduce(over_rationals(function.numerator), over_rationals(function.denominator)) ==
                function,
            "normal form of a rational function");
    return function;
}

Polynomial to_polynomial(const ExactFunction& function) {
    require(function.denominator.size() == 1, "a polynomial");
    return over_rationals(function.numerator) * constant(1 / Rational(function.denominator[0]));
}

ExactFunction read_function(const nmbc::RationalFunction& function) {
    return make_function(split(function.numerator), split(function.denominator));
}

/// {"num": [..], "den": [..]}, or "p/q" in a table at a fixed G.
ExactFunction read_function(const Json& json) {
    if (json.is_string()) {
        return to_rational_function(constant(read_rational(json.get<std::string>())));
    }
    require(json.size() == 2, "num and den");
    const auto integers = [](const Json& list) {
        std::vector<Integer> result;
        for (const Json& item : list) {
            result.push_back(read_integer(item.get<std::string>()));
        }
        return result;
    };
    return make_function(integers(json.at("num")), integers(json.at("den")));
}

template <class List>
std::vector<ExactFunction> read_functions(const List& list) {
    std::vector<ExactFunction> result;
    for (const auto& item : list) {
        result.push_back(read_function(item));
    }
    return result;
}

template <class List>
std::vector<Polynomial> read_polynomials(const List& list) {
    std::vector<Polynomial> result;
    for (const auto& item : list) {
        result.push_back(to_polynomial(read_function(item)));
    }
    return result;
}

template <class List>
std::vector<Rational> read_numbers(const List& list) {
    std::vector<Rational> result;
    for (const Polynomial& number : read_polynomials(list)) {
        require(number.size() <= 1, "a number, the same at every G");
        result.push_back(evaluate(number, 0));
    }
    return result;
}

ExactSquare read_square(const nmbc::EnergySquare& square) {
    const Integer divisor = read_integer(std::string(square.divisor));
    require(divisor > 0, "a positive divisor");
    Integer content = divisor;
    std::vector<Rational> stencil;
    for (const Integer& entry : split(square.stencil)) {
        content = gcd(content, entry);
        stencil.emplace_back(entry, divisor);
    }
    require(content == 1, "stencil and divisor without common factor");
    return {square.part, to_polynomial(read_function(square.weight)), std::move(stencil)};
}

ExactSquare read_square(const Json& json) {
    require(json.size() == 3, "part, weight and stencil");
    std::vector<Rational> stencil;
    for (const Json& entry : json.at("stencil")) {
        stencil.push_back(read_rational(entry.get<std::string>()));
    }
    const auto part = json.at("part").get<std::string>();
    const bool strain = part == name_of(EnergyPart::strain);
    require(strain || part == name_of(EnergyPart::stabilisation), "a known part of the energy");
    return {strain ? EnergyPart::strain : EnergyPart::stabilisation,
            to_polynomial(read_function(json.at("weight"))), std::move(stencil)};
}

template <class List>
std::vector<ExactSquare> read_energy(const List& list) {
    std::vector<ExactSquare> result;
    for (const auto& item : list) {
        result.push_back(read_square(item));
    }
    return result;
}

unsigned read_count(long long value) {
    require(value >= 1 && value <= 1000, "a positive count");
    return unsigned(value);
}

void require_least_nodes(long long nodes, const Rational& tau) {
    require(nodes == (tau > 0 ? least_damped_nodes : 0), "the least number of nodes");
}

/// Beyond prove(): the family has this very model, and the words are the generator's.
void verify(const Table& table) {
    require(prove(table) == table.proved, "the statement of what is proved");
    Model model = make_model(table.specification.family, table.specification.horizon,
                             table.specification.damping);
    require(table.model.damping == model.damping, "the damping of the family");
    if (const auto& G = table.specification.stabilisation) {
        for (Polynomial& coefficient : model.symbol) {
            coefficient = constant(evaluate(coefficient, *G));
        }
    }
    require(table.model.symbol == model.symbol, "the symbol of the family");
    require(table.source == model.source +
                                "; Nicely 2018: Taylor coefficients (47), matching (49), ghost "
                                "layers (60)",
            "the source");
}

template <class Check>
std::string message_of(Check check) {
    try {
        check();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

}  // namespace

Table read_table(const nmbc::MatchingTable& from) {
    Table table;
    table.specification = {.family = std::string(from.family),
                           .horizon = read_count(from.horizon),
                           .order = read_count(from.order),
                           .stride = read_count(from.stride),
                           .stabilisation = {},
                           .damping = read_rational(std::string(from.tau)),
                           .time_step = read_rational(std::string(from.time_step))};
    require_least_nodes(from.least_nodes, table.specification.damping);
    if (!from.fixed_G.empty()) {
        table.specification.stabilisation = read_rational(std::string(from.fixed_G));
    }
    table.model.damping = read_numbers(from.damping);
    table.model.energy = read_energy(from.energy);
    table.model.symbol = read_polynomials(from.symbol);
    table.taylor = read_polynomials(from.taylor);
    table.c = read_functions(from.c);
    table.b = read_functions(from.b);
    table.source = from.source;
    table.proved = from.proved;
    return table;
}

Table read_table(const Json& from) {
    std::string keys;
    for (const auto& item : from.items()) {
        keys += item.key() + ' ';
    }
    require(keys ==
                "schema family order horizon stride G tau time_step symbol damping energy taylor c "
                "b source "
                "proved windows least_nodes poles max_cfl max_cfl_contractive certificate ",
            "the keys of schema 4, in order");
    require(from.at("schema") == 4, "schema 4");
    const auto count = [&from](const char* key) {
        require(from.at(key).is_number_integer(), std::string(key) + " is a whole number");
        return read_count(from.at(key).get<long long>());
    };
    Table table;
    table.specification = {.family = from.at("family").get<std::string>(),
                           .horizon = count("horizon"),
                           .order = count("order"),
                           .stride = count("stride"),
                           .stabilisation = {},
                           .damping = read_rational(from.at("tau").get<std::string>()),
                           .time_step = read_rational(from.at("time_step").get<std::string>())};
    require(from.at("least_nodes").is_number_integer(), "least_nodes is a whole number");
    require_least_nodes(from.at("least_nodes").get<long long>(), table.specification.damping);
    if (!from.at("G").is_null()) {
        table.specification.stabilisation = read_rational(from.at("G").get<std::string>());
    }
    table.model.damping = read_numbers(from.at("damping"));
    table.model.energy = read_energy(from.at("energy"));
    table.model.symbol = read_polynomials(from.at("symbol"));
    table.taylor = read_polynomials(from.at("taylor"));
    table.c = read_functions(from.at("c"));
    table.b = read_functions(from.at("b"));
    table.source = from.at("source").get<std::string>();
    table.proved = from.at("proved").get<std::string>();
    if (!from.at("certificate").is_null()) {
        table.certificate = read_certificate(from);
    }
    return table;
}

std::string objection(const nmbc::MatchingTable& from) {
    return message_of([&from] {
        const Table table = read_table(from);
        require(from.name == table_name(table.specification), "the name");
        verify(table);
    });
}

std::string objection(const Json& from) {
    return message_of([&from] { verify(read_table(from)); });
}

std::string file_objection(const Json& file) {
    return message_of([&file] {
        require(file.size() == 2 && file.at("schema") == 4, "schema 4 and tables");
        const auto set = committed_set();
        require(file.at("tables").size() == set.size(), "as many tables as the committed set");
        for (std::size_t i = 0; i < set.size(); ++i) {
            const Table table = read_table(file.at("tables")[i]);
            require(table_name(table.specification) == table_name(set[i]), "the committed set");
            verify(table);
        }
    });
}

}  // namespace nmbcgen::test
