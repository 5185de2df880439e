// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>
#include <utility>

#include "generator/emit/certificate_json.hpp"
#include "generator/emit/certificate_text.hpp"
#include "generator/emit/emit.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/names/names.hpp"
#include "generator/table/schema.hpp"

namespace nmbcgen {
namespace {

using Json = nlohmann::ordered_json;

Json exact_list(const IntegerPolynomial& polynomial) {
    Json list = Json::array();
    for (const Integer& coefficient : polynomial.data()) {
        list.push_back(coefficient.str());
    }
    if (list.empty()) {
        list.push_back("0");
    }
    return list;
}

/// {"num": .., "den": ..}, or "p/q" in a table at a fixed G, where all is constant.
Json exact(const ExactFunction& function, bool at_fixed_G) {
    if (at_fixed_G) {
        const Integer p = function.numerator.is_zero() ? Integer(0) : function.numerator[0];
        return to_string(Rational(p, function.denominator[0]));
    }
    return {{"num", exact_list(function.numerator)}, {"den", exact_list(function.denominator)}};
}

Json exact(const Polynomial& polynomial, bool at_fixed_G) {
    return exact(to_rational_function(polynomial), at_fixed_G);
}

Json exact(const Rational& number, bool at_fixed_G) {
    return exact(constant(number), at_fixed_G);
}

template <class Item>
Json exact_array(const std::vector<Item>& items, bool at_fixed_G) {
    Json array = Json::array();
    for (const Item& item : items) {
        array.push_back(exact(item, at_fixed_G));
    }
    return array;
}

Json energy_array(const std::vector<ExactSquare>& energy) {
    Json array = Json::array();
    for (const ExactSquare& square : energy) {
        Json stencil = Json::array();
        for (const Rational& entry : square.stencil) {
            stencil.push_back(to_string(entry));
        }
        array.push_back({{"part", name_of(square.part)},
                         {"weight", exact(square.weight, false)},
                         {"stencil", stencil}});
    }
    return array;
}

/// A table's lattice, at every G.
Json lattice_object(const Table& table) {
    const Specification& what = table.specification;
    Json object = {
        {"name", lattice_name(what)}, {"family", what.family}, {"horizon", what.horizon}};
    for (const Rational& weight : what.weights) {
        object["weights"].push_back(to_string(weight));
    }
    object["tau"] = to_string(what.damping);
    object["symbol"] = exact_array(table.model.symbol, false);
    object["damping"] = exact_array(table.model.damping, false);
    object["energy"] = energy_array(table.model.energy);
    object["source"] = table.model.source;
    return object;
}

/// "match" and "digits", only of a table that has matching points besides xi = 0.
void add_points(Json& object, const Table& table) {
    if (table.specification.points.empty()) {
        return;
    }
    object["match"] = matching_text(table.specification);
    object["digits"] = table.digits;
}

/// lattice: the object, or its name.
Json table_object(const Table& table, Json lattice) {
    const Specification& what = table.specification;
    const bool fixed = what.stabilisation.has_value();
    const bool damped = what.damping > 0;
    const Certificate certificate = table.certificate.value_or(Certificate{});
    const auto if_sought = [&table](Json found) {
        return table.certificate ? std::move(found) : Json(nullptr);
    };
    Json object = {
        {"schema", json_schema},
        {"lattice", std::move(lattice)},
        {"order", what.order},
        {"stride", what.stride},
        {"G", fixed ? Json(to_string(*what.stabilisation)) : Json(nullptr)},
        {"time_step", to_string(what.time_step)},
        {"taylor", exact_array(table.taylor, fixed)},
        {"c", exact_array(table.c, fixed)},
        {"b", exact_array(table.b, fixed)},
        {"source", table.source},
        {"proved", table.proved},
        {"windows", if_sought(windows_object(certificate, damped))},
        {"least_nodes", if_sought(certificate.least_nodes)},
        {"poles", if_sought(poles_array(certificate))},
        {"max_cfl", if_sought(steps_array(certificate.max_cfl))},
        {"max_cfl_contractive", if_sought(steps_array(certificate.max_cfl_contractive))},
        {"evidence", if_sought(evidence_object(certificate, damped))},
        {"certificate", table.certificate ? Json(certificate_statement(table)) : Json(nullptr)}};
    if (table.in_plane) {
        object["plane"] = {{"grade", table.in_plane->grade},
                           {"evidence", "sampled"},
                           {"samples", table.in_plane->samples},
                           {"steps", table.in_plane->steps},
                           {"grows_opposite", table.in_plane->grows_opposite}};
    }
    add_points(object, table);
    return object;
}

std::string dumped(const Json& json) {
    return json.dump(1) + "\n";
}

}  // namespace

std::string emit_json(const Table& table) {
    return dumped(table_object(table, lattice_object(table)));
}

std::string emit_json(std::span<const Table> tables) {
    Json lattices = Json::array();
    for (const Table& table : one_of_each_lattice(tables)) {
        lattices.push_back(lattice_object(table));
    }
    Json list = Json::array();
    for (const Table& table : tables) {
        list.push_back(table_object(table, lattice_name(table.specification)));
    }
    return dumped({{"schema", json_schema}, {"lattices", lattices}, {"tables", list}});
}

}  // namespace nmbcgen
