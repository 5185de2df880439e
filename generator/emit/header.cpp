// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "generator/emit/certificate_text.hpp"
#include "generator/emit/coefficients.hpp"
#include "generator/emit/cpp_source.hpp"
#include "generator/emit/emit.hpp"
#include "generator/emit/heading.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/names/names.hpp"

namespace nmbcgen {
namespace {

constexpr auto initialiser_line = [](const auto& item) {
    return "    " + initialiser(item) + ",\n";
};

/// The coefficients of a table at a fixed G, rounded once: for copying into other programs.
std::string rounded_array(const CoefficientList& list) {
    std::string text = fmt::format("inline constexpr double rounded_{}[]{{\n", list.name);
    for (std::size_t i = 0; i < list.functions.size(); ++i) {
        const Rational value = evaluate(list.functions[i], 0);
        const double rounded = nearest_double(value);
        text += fmt::format("    {:a},  // {:.17g}{}\n", rounded, rounded,
                            list.digits > 0 ? "" : " = " + to_string(value));
    }
    return text + "};\n";
}

/// The table's own namespace and the table.
std::string condition_source(const Table& table) {
    const Specification& what = table.specification;
    const std::string name = table_name(what);
    const std::string G = what.stabilisation ? to_string(*what.stabilisation) : "";
    const bool damped = what.damping > 0;
    const Certificate certificate = table.certificate.value_or(Certificate{});

    std::string text =
        fmt::format("namespace nmbc::generated {{\n\nnamespace {}_data {{\n\n", name);
    text += array("RationalFunction", "taylor", table.taylor, initialiser_line);
    text += array("RationalFunction", "c", table.c, initialiser_line);
    text += array("RationalFunction", "b", table.b, initialiser_line);
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
        "    .lattice = &{1},\n"
        "    .order = {2},\n"
        "    .stride = {3},\n"
        "    .fixed_G = \"{4}\",\n"
        "    .time_step = \"{5}\",\n"
        "    .source = \"{6}\",\n"
        "    .proved = \"{7}\",\n"
        "    .taylor = {0}_data::taylor,\n"
        "    .c = {0}_data::c,\n"
        "    .b = {0}_data::b,\n",
        name, lattice_name(what), what.order, what.stride, G, to_string(what.time_step),
        table.source, table.proved);
    text += window_members(name, certificate, damped);
    text += fmt::format("    .least_nodes = {},\n", certificate.least_nodes);
    return text + "};\n\n}  // namespace nmbc::generated\n";
}

std::string include_of(const std::string& name) {
    return fmt::format("#include <nmbc/tables/{}.hpp>\n", name);
}

}  // namespace

std::string emit_header(const Table& table) {
    return heading("//", table, "") + "#pragma once\n\n" +
           cpp_preamble(include_of(lattice_name(table.specification))) + condition_source(table);
}

std::string emit_header_with_lattice(const Table& table) {
    return heading("//", table, "") + "#pragma once\n\n" + lattice_source(table) + "\n" +
           condition_source(table);
}

std::string emit_registry(std::span<const Table> tables) {
    std::string includes;
    std::string lattices;
    std::string conditions;
    for (const Table& table : one_of_each_lattice(tables)) {
        const std::string name = lattice_name(table.specification);
        includes += include_of(name);
        lattices += fmt::format("    &{},\n", name);
    }
    for (const Table& table : tables) {
        const std::string name = table_name(table.specification);
        includes += include_of(name);
        conditions += fmt::format("    &{},\n", name);
    }
    return banner("//", "nmbcgen --all") + "#pragma once\n\n" + includes +
           "\nnamespace nmbc::generated {\n\n"
           "/// Every lattice of this folder; nmbc::find_lattice looks one up.\n"
           "inline constexpr const LatticeTable* lattices[]{\n" +
           lattices +
           "};\n\n"
           "/// Every table of this folder; nmbc::find_table looks one up.\n"
           "inline constexpr const MatchingTable* tables[]{\n" +
           conditions + "};\n\n}  // namespace nmbc::generated\n";
}

}  // namespace nmbcgen
