// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/emit/coefficients.hpp"
#include "generator/emit/emit.hpp"
#include "generator/emit/heading.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/names/names.hpp"

namespace nmbcgen {
namespace {

/// A literal of type double.
std::string literal(double value) {
    const std::string text = fmt::format("{}", value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

/// By Horner's rule.
std::string expression(const IntegerPolynomial& polynomial) {
    std::string text;
    for (std::size_t k = std::max<std::size_t>(polynomial.size(), 1); k-- > 0;) {
        const Rational coefficient = k < polynomial.size() ? Rational(polynomial[k]) : Rational(0);
        const std::string number = literal(nearest_double(coefficient));
        text = text.empty() ? number : fmt::format("{} + G * ({})", number, text);
    }
    return text;
}

std::string function_of_G(const std::string& table, const CoefficientList& list) {
    std::string text =
        fmt::format("static inline void {}_{}(double G, double {}[{}]) {{\n    (void)G;\n", table,
                    list.name, list.name, list.functions.size());
    for (std::size_t i = 0; i < list.functions.size(); ++i) {
        const ExactFunction& function = list.functions[i];
        const std::string denominator = expression(function.denominator);
        text += fmt::format("    {}[{}] = {}{};\n", list.name, i,
                            denominator == "1.0" ? expression(function.numerator)
                                                 : "(" + expression(function.numerator) + ")",
                            denominator == "1.0" ? "" : " / (" + denominator + ")");
    }
    return text + "}\n\n";
}

std::string constants(const std::string& table, const CoefficientList& list) {
    std::string text = fmt::format("static const double {}_{}[{}] = {{\n", table, list.name,
                                   list.functions.size());
    for (const ExactFunction& function : list.functions) {
        const Rational value = evaluate(function, 0);
        text += fmt::format("    {:a}, // {}\n", nearest_double(value), to_string(value));
    }
    return text + "};\n\n";
}

std::string certified_steps(const std::string& table, const std::string& which,
                            const std::vector<StableStep>& steps, double StableStep::*cfl) {
    std::string text =
        fmt::format("static inline double {}_{}_cfl(double G) {{\n    (void)G;\n", table, which);
    // Where two pieces meet, both hold.
    std::vector<StableStep> descending = steps;
    std::ranges::stable_sort(descending, std::ranges::greater(), &StableStep::cfl);
    for (const StableStep& step : descending) {
        text += fmt::format(
            "    if ({} <= G{}) return {};\n", literal(step.window.low),
            std::isinf(step.window.high) ? std::string() : " && G <= " + literal(step.window.high),
            step.*cfl);
    }
    return text + "    return 0;\n}\n\n";
}

}  // namespace

std::string emit_c(const Table& table) {
    const Specification& what = table.specification;
    const std::string name = table_name(what);
    const bool fixed = what.stabilisation.has_value();
    const Certificate certificate = table.certificate.value_or(Certificate{});
    std::string text = heading("//", table, " --format c");
    text += fmt::format("#ifndef NMBC_{0}_H\n#define NMBC_{0}_H\n\n", name);
    text += fmt::format("// {}. Needs C99 or C++17, no library.\n", title(what));
    text += fmt::format(
        "enum {{\n    {0}_horizon = {1},\n    {0}_order = {2},\n    {0}_stride = {3},\n"
        "    {0}_ghost_layers = {4},\n    {0}_least_nodes = {5}\n}};\n\n",
        name, what.horizon, what.order, what.stride, table.model.symbol.size() - 1,
        certificate.least_nodes);
    text += fmt::format(
        "// dt [dX/c] it is matched in; 0: continuous time.\n"
        "static const double {}_time_step = {};\n\n",
        name, literal(nearest_double(what.time_step)));
    text +=
        "// omega^2 = symbol[0] + 2 sum_m symbol[m] cos(m xi), tau sigma likewise of damping;\n"
        "// taylor: a_1 .. a_(2N+1) of (47); c and b of (60).\n";
    for (const CoefficientList& list : coefficient_lists(table)) {
        if (!list.functions.empty()) {
            text += fixed ? constants(name, list) : function_of_G(name, list);
        }
    }
    text +=
        "// The largest certified cfl = dt omega_max / 2 at G, both ends alike, midpoint ghosts; "
        "0:\n"
        "// none.\n";
    // Any end may be a like one.
    std::vector<StableStep> steps = certificate.max_cfl;
    steps.insert(steps.end(), certificate.max_cfl_contractive.begin(),
                 certificate.max_cfl_contractive.end());
    return text + certified_steps(name, "largest", steps, &StableStep::cfl) +
           certified_steps(name, "smallest", steps, &StableStep::from) + "#endif\n";
}

}  // namespace nmbcgen
