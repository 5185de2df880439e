// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/support/read_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "generator/emit/certificate_json.hpp"
#include "generator/emit/coefficients.hpp"
#include "generator/emit/emit.hpp"
#include "generator/exact/exact_table.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"
#include "generator/matching/proof.hpp"
#include "generator/names/names.hpp"
#include "generator/pipeline.hpp"
#include "generator/table/schema.hpp"
#include "tools/nmbcrun/scene/table_file.hpp"

namespace nmbcgen::test {
namespace {

void require(bool holds, const std::string& statement) {
    if (!holds) {
        throw std::runtime_error("not so: " + statement);
    }
}

/// Whether the text is that of the function in its normal form.
bool is_written_so(const nmbc::RationalFunction& text, const ExactFunction& function) {
    const auto joined = [](const IntegerPolynomial& polynomial) {
        return fmt::format("{}", fmt::join(texts_of(polynomial), " "));
    };
    return text.numerator == joined(function.numerator) &&
           text.denominator == joined(function.denominator) &&
           reduce(over_rationals(function.numerator), over_rationals(function.denominator)) ==
               function;
}

void require_written_so(std::span<const nmbc::RationalFunction> texts,
                        const std::vector<ExactFunction>& functions) {
    for (std::size_t i = 0; i < functions.size(); ++i) {
        require(is_written_so(texts[i], functions[i]), "normal form of a function");
    }
}

template <class Item>
void require_written_so(std::span<const nmbc::RationalFunction> texts,
                        const std::vector<Item>& polynomials) {
    for (std::size_t i = 0; i < polynomials.size(); ++i) {
        require(is_written_so(texts[i], to_rational_function(Polynomial{polynomials[i]})),
                "normal form of a polynomial");
    }
}

void require_written_so(const nmbc::EnergySquare& text, const ExactSquare& square) {
    Integer divisor{std::string(text.divisor)};
    std::string stencil;
    Integer content = divisor;
    for (const Rational& entry : square.stencil) {
        const Integer integer = numerator(Rational(entry * divisor));
        content = gcd(content, integer);
        stencil += (stencil.empty() ? "" : " ") + integer.str();
    }
    require(content == 1 && stencil == text.stencil && divisor.str() == text.divisor,
            "normal form of a stencil");
}

/// Beyond prove(): the family has this very model, and the words are the generator's.
void verify(const Table& table) {
    require(prove(table) == table.proved, "the statement of what is proved");
    const Specification& what = table.specification;
    const Model model = make_model(what.family, what.horizon, what.damping, what.weights);
    require(table.model.damping == model.damping, "the damping of the family");
    require(table.model.symbol == model.symbol, "the symbol of the family");
    require(table.model.source == model.source, "the source of the model");
    require(
        table.source == "Nicely 2018: Taylor coefficients (47), matching (49), ghost layers (60)",
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
    const nmbc::LatticeTable& lattice = *from.lattice;
    for (const int count : {lattice.horizon, from.order, from.stride}) {
        require(count >= 1 && count <= 1000, "a positive count");
    }
    for (const nmbc::EnergySquare& square : lattice.energy) {
        require(Integer(std::string(square.divisor)) > 0, "a positive divisor");
    }
    Table table = exact_table(from);
    const Specification& what = table.specification;
    require(lattice.weights == weights_text(what), "the influence");
    require_written_so(lattice.symbol, table.model.symbol);
    require_written_so(lattice.damping, table.model.damping);
    require_written_so(from.taylor, table.taylor);
    require_written_so(from.c, table.c);
    require_written_so(from.b, table.b);
    for (std::size_t i = 0; i < lattice.energy.size(); ++i) {
        const ExactSquare& square = table.model.energy[i];
        require_written_so(lattice.energy[i], square);
        require_written_so({&lattice.energy[i].weight, 1}, std::vector{square.weight});
    }
    return table;
}

Table read_table(const Json& from) {
    const nmbcrun::TableFile file(from.dump(), "JSON");
    Table table = exact_table(file.tables().at(0).table);
    if (!from.at("certificate").is_null()) {
        table.certificate = read_certificate(from);
    }
    return table;
}

Json with_lattice(const Json& file, std::size_t i) {
    Json table = file.at("tables").at(i);
    const auto lattice = std::ranges::find_if(file.at("lattices"), [&](const Json& each) {
        return each.at("name") == table.at("lattice");
    });
    require(lattice != file.at("lattices").end(), "a lattice of this name");
    table["lattice"] = *lattice;
    return table;
}

std::string objection(const nmbc::MatchingTable& from) {
    return message_of([&from] {
        const Table table = read_table(from);
        require(from.lattice->name == lattice_name(table.specification), "the lattice's name");
        require(from.name == table_name(table.specification), "the name");
        verify(table);
    });
}

std::string objection(const Json& from) {
    return message_of([&from] {
        const Table table = read_table(from);
        verify(table);
        require(Json::parse(emit_json(table)).dump() == from.dump(), "the form of JSON");
    });
}

std::string file_objection(const Json& file) {
    return message_of([&file] {
        require(file.size() == 3 && file.at("schema") == json_schema,
                "schema, lattices and tables");
        const auto set = committed_set();
        require(file.at("tables").size() == set.size(), "as many tables as the committed set");
        for (std::size_t i = 0; i < set.size(); ++i) {
            const Json one = with_lattice(file, i);
            require(table_name(read_table(one).specification) == table_name(set[i]),
                    "the committed set");
            const std::string found = objection(one);
            if (!found.empty()) {
                throw std::runtime_error(found);
            }
        }
    });
}

}  // namespace nmbcgen::test
