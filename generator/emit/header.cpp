// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "generator/emit/array.hpp"
#include "generator/emit/certificate_text.hpp"
#include "generator/emit/coefficients.hpp"
#include "generator/emit/emit.hpp"
#include "generator/emit/heading.hpp"
#include "generator/exact/algebraic_number.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/names/names.hpp"

namespace nmbcgen {
namespace {

std::string coefficient_list(const IntegerPolynomial& polynomial) {
    std::string list;
    for (const Integer& coefficient : polynomial.data()) {
        list += (list.empty() ? "" : " ") + coefficient.str();
    }
    return list.empty() ? "0" : list;
}

std::string initialiser(const ExactFunction& function) {
    return fmt::format(R"({{"{}", "{}"}})", coefficient_list(function.numerator),
                       coefficient_list(function.denominator));
}

std::string initialiser(const Polynomial& polynomial) {
    return initialiser(to_rational_function(polynomial));
}

std::string initialiser(const Rational& number) {
    return initialiser(constant(number));
}

std::string initialiser(const ExactSquare& square) {
    // The stencil as integers over a common divisor: a polynomial in z over an integer.
    const ExactFunction stencil =
        to_rational_function(Polynomial(square.stencil.begin(), square.stencil.end()));
    IntegerPolynomial padded = stencil.numerator;
    padded.data().resize(square.stencil.size(), Integer(0));  // Polynomial drops zeros at the end
    return fmt::format(R"({{EnergyPart::{}, {}, "{}", "{}"}})", name_of(square.part),
                       initialiser(square.weight), coefficient_list(padded),
                       coefficient_list(stencil.denominator));
}

constexpr auto line_of = [](const auto& item) {
    return fmt::format("    {},\n", initialiser(item));
};

/// The coefficients of a table at a fixed G, rounded once: for copying into other programs.
std::string rounded_array(const CoefficientList& list) {
    std::string text = fmt::format("inline constexpr double rounded_{}[]{{\n", list.name);
    for (std::size_t i = 0; i < list.functions.size(); ++i) {
        const Rational value = evaluate(list.functions[i], 0);
        const double rounded = nearest_double(value);
        const std::string exact = list.closed.empty() ? to_string(value) : to_text(list.closed[i]);
        text += fmt::format("    {:a},  // {:.17g}{}\n", rounded, rounded,
                            list.digits > 0 && list.closed.empty() ? "" : " = " + exact);
    }
    return text + "};\n";
}

std::string schema_check() {
    return fmt::format(
        "static_assert(nmbc::table_schema == {},\n"
        "              \"tables and runtime differ: run the target 'regenerate'\");\n",
        nmbc::table_schema);
}

}  // namespace

std::string emit_header(const Table& table) {
    const Specification& what = table.specification;
    const std::string name = table_name(what);
    const std::string G = what.stabilisation ? to_string(*what.stabilisation) : "";
    const bool damped = what.damping > 0;
    const std::string dt = to_string(what.time_step);
    const std::string tau = to_string(what.damping);
    const Certificate certificate = table.certificate.value_or(Certificate{});

    std::string text = heading("//", table, "");
    text += "#pragma once\n\n#include <nmbc/table.hpp>\n\n" + schema_check() + "\n";
    text += fmt::format("namespace nmbc::generated {{\n\nnamespace {}_data {{\n\n", name);
    text += array("RationalFunction", "symbol", table.model.symbol, line_of);
    text += array("RationalFunction", "damping", table.model.damping, line_of);
    text += array("EnergySquare", "energy", table.model.energy, line_of);
    text += array("RationalFunction", "taylor", table.taylor, line_of);
    text += array("RationalFunction", "c", table.c, line_of);
    text += array("RationalFunction", "b", table.b, line_of);
    text += window_arrays(certificate);
    if (what.stabilisation) {
        text += "/// c_j and b_j rounded to nearest: hexadecimal, 17 digits, exact.\n";
        text += rounded_array(c_list(table)) + "\n";
        text += rounded_array(b_list(table)) + "\n";
    }
    text += fmt::format("}}  // namespace {}_data\n\n", name);
    text += fmt::format("/// {}.\n", title(what));
    text += fmt::format(
        "inline constexpr MatchingTable {0}{{\n"
        "    .name = \"{0}\",\n"
        "    .family = \"{1}\",\n"
        "    .horizon = {2},\n"
        "    .order = {3},\n"
        "    .stride = {4},\n"
        "    .fixed_G = \"{5}\",\n"
        "    .tau = \"{6}\",\n"
        "    .time_step = \"{7}\",\n"
        "    .source = \"{8}\",\n"
        "    .proved = \"{9}\",\n"
        "    .symbol = {0}_data::symbol,\n"
        "    .damping = {10},\n"
        "    .energy = {0}_data::energy,\n"
        "    .taylor = {0}_data::taylor,\n"
        "    .c = {0}_data::c,\n"
        "    .b = {0}_data::b,\n",
        name, what.family, what.horizon, what.order, what.stride, G, tau, dt, table.source,
        table.proved, damped ? name + "_data::damping" : "{}");
    text += window_members(name, certificate, damped);
    text += fmt::format("    .least_nodes = {},\n", damped ? least_damped_nodes : 0);
    return text + "};\n\n}  // namespace nmbc::generated\n";
}

std::string emit_registry(std::span<const Table> tables) {
    std::string text = banner("//", "nmbcgen --all");
    text += "#pragma once\n\n";
    for (const Table& table : tables) {
        text += fmt::format("#include <nmbc/tables/{}.hpp>\n", table_name(table.specification));
    }
    text +=
        "\nnamespace nmbc::generated {\n\n"
        "/// Every table of this folder; nmbc::find_table looks one up.\n"
        "inline constexpr const MatchingTable* tables[]{\n";
    for (const Table& table : tables) {
        text += fmt::format("    &{},\n", table_name(table.specification));
    }
    return text + "};\n\n}  // namespace nmbc::generated\n";
}

}  // namespace nmbcgen
