// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "generator/emit/coefficients.hpp"
#include "generator/emit/emit.hpp"
#include "generator/emit/heading.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"

namespace nmbcgen {
namespace {

std::string power_of_G(std::size_t power) {
    return power == 0 ? "" : power == 1 ? "G" : fmt::format("G^{{{}}}", power);
}

/// 30-16G, by ascending powers; "0" of the zero polynomial.
std::string polynomial(const IntegerPolynomial& coefficients) {
    std::string text;
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
        if (coefficients[k] == 0) {
            continue;
        }
        const bool negative = coefficients[k] < 0;
        const Integer size = abs(coefficients[k]);
        text += negative ? "-" : text.empty() ? "" : "+";
        text += (size == 1 && k > 0 ? "" : size.str()) + power_of_G(k);
    }
    return text.empty() ? "0" : text;
}

/// A fraction, its sign in front where the numerator has one term.
std::string fraction(const ExactFunction& function) {
    std::string numerator = polynomial(function.numerator);
    const std::string denominator = polynomial(function.denominator);
    if (denominator == "1") {
        return numerator;
    }
    const bool minus =
        numerator.front() == '-' && numerator.find_first_of("+-", 1) == std::string::npos;
    return fmt::format("{}\\frac{{{}}}{{{}}}", minus ? "-" : "",
                       minus ? numerator.substr(1) : numerator, denominator);
}

/// What the i-th coefficient is; its decimals where it has no short form.
std::string value(const CoefficientList& list, std::size_t i) {
    if (list.digits > 0 && list.functions[i].denominator != IntegerPolynomial(Integer(1))) {
        return fmt::format("\\approx {:.17g}", nearest_double(evaluate(list.functions[i], 0)));
    }
    return "= " + fraction(list.functions[i]);
}

/// The letters of the lists, as in (47), (60) and the table's symbol.
std::string letter(std::string_view name) {
    return name == "symbol"    ? "s"
           : name == "damping" ? "d"
           : name == "taylor"  ? "a"
                               : std::string(name);
}

std::string unit(std::string_view name) {
    return name == "b" || name == "damping" ? "\\,c/\\Delta X" : "";
}

}  // namespace

std::string emit_latex(const Table& table) {
    std::string text = heading("%", table, " --format latex");
    text += fmt::format(
        "% {}. Needs amsmath.\n"
        "% omega^2 = s_0 + 2 sum_m s_m cos(m xi), tau sigma = d_0 + 2 sum_m d_m cos(m xi) "
        "likewise,\n"
        "% s = sum_k a_k (i xi)^k; Delta X = c = 1 in s_m and a_k.\n",
        title(table.specification));
    for (const CoefficientList& list : coefficient_lists(table)) {
        if (list.functions.empty()) {
            continue;
        }
        text += "\\begin{align*}\n";
        for (std::size_t i = 0; i < list.functions.size(); ++i) {
            text += fmt::format("  {}_{{{}}} &{}{}{}\n", letter(list.name), list.first + i,
                                value(list, i), unit(list.name),
                                i + 1 < list.functions.size() ? " \\\\" : "");
        }
        text += "\\end{align*}\n";
    }
    return text;
}

}  // namespace nmbcgen
