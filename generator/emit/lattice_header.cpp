// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "generator/emit/coefficients.hpp"
#include "generator/emit/cpp_source.hpp"
#include "generator/emit/emit.hpp"
#include "generator/emit/heading.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/names/names.hpp"

namespace nmbcgen {
namespace {

std::string line_of_function(const Polynomial& polynomial) {
    return "    " + initialiser(polynomial) + ",\n";
}

std::string line_of_number(const Rational& number) {
    return line_of_function(constant(number));
}

std::string line_of_square(const ExactSquare& square) {
    // The stencil as integers over a common divisor: a polynomial in z over an integer.
    const ExactFunction stencil =
        to_rational_function(Polynomial(square.stencil.begin(), square.stencil.end()));
    IntegerPolynomial padded = stencil.numerator;
    padded.data().resize(square.stencil.size(), Integer(0));  // Polynomial drops zeros at the end
    return fmt::format("    {{EnergyPart::{}, {}, \"{}\", \"{}\"}},\n", name_of(square.part),
                       initialiser(square.weight), fmt::join(texts_of(padded), " "),
                       fmt::join(texts_of(stencil.denominator), " "));
}

}  // namespace

std::vector<Table> one_of_each_lattice(std::span<const Table> tables) {
    std::vector<Table> found;
    for (const Table& table : tables) {
        const auto is_its = [&](const Table& other) {
            return lattice_name(other.specification) == lattice_name(table.specification);
        };
        if (std::ranges::none_of(found, is_its)) {
            found.push_back(table);
        }
    }
    return found;
}

std::string lattice_source(const Table& table) {
    const Specification& what = table.specification;
    const Model& model = table.model;
    const std::string name = lattice_name(what);
    std::string text = fmt::format("#ifndef NMBC_LATTICE_{0}\n#define NMBC_LATTICE_{0}\n\n", name);
    text += cpp_preamble("") +
            fmt::format("namespace nmbc::generated {{\n\nnamespace {}_data {{\n\n", name);
    text += array("RationalFunction", "symbol", model.symbol, line_of_function);
    text += array("RationalFunction", "damping", model.damping, line_of_number);
    text += array("EnergySquare", "energy", model.energy, line_of_square);
    text += fmt::format("}}  // namespace {}_data\n\n", name);
    text += fmt::format(
        "/// {1}.\n"
        "inline constexpr LatticeTable {0}{{\n"
        "    .name = \"{0}\",\n"
        "    .family = \"{2}\",\n"
        "    .horizon = {3},\n"
        "    .weights = \"{4}\",\n"
        "    .tau = \"{5}\",\n"
        "    .source = \"{6}\",\n"
        "    .symbol = {0}_data::symbol,\n"
        "    .damping = {7},\n"
        "    .energy = {0}_data::energy,\n"
        "}};\n\n",
        name, model.description, what.family, what.horizon, weights_text(what),
        to_string(what.damping), model.source,
        model.damping.empty() ? "{}" : name + "_data::damping");
    return text + "}  // namespace nmbc::generated\n\n#endif\n";
}

std::string emit_lattice_header(const Table& table) {
    const Specification& what = table.specification;
    const Specification plainest{.family = what.family,
                                 .horizon = what.horizon,
                                 .stabilisation = {},
                                 .damping = what.damping,
                                 .weights = what.weights};
    return banner("//", regenerating_command(plainest)) +
           fmt::format(
               "// model   {}\n"
               "// source  {}\n"
               "// units   xi in 1/dX, omega{} in c/dX, G without dimension\n",
               table.model.description, table.model.source, what.damping > 0 ? ", tau" : "") +
           lattice_source(table);
}

}  // namespace nmbcgen
