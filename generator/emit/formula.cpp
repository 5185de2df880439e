// SPDX-License-Identifier: MIT
#include "generator/emit/formula.hpp"

#include <fmt/format.h>

#include <regex>

#include "generator/exact/algebraic_number.hpp"
#include "generator/exact/factors.hpp"
#include "generator/exact/rational_function.hpp"

namespace nmbcgen {
namespace {

/// base^3, base of the power 1, nothing of the power 0.
std::string power(std::string_view base, std::size_t exponent, Notation notation) {
    if (exponent == 0) {
        return "";
    }
    const char* const form = notation == Notation::latex ? "{}^{{{}}}" : "{}^{}";
    return exponent == 1 ? std::string(base) : fmt::format(fmt::runtime(form), base, exponent);
}

std::string fraction(const std::string& numerator, const std::string& denominator, bool product,
                     Notation notation) {
    if (denominator.empty()) {
        return numerator;
    }
    if (notation == Notation::latex) {
        return fmt::format("\\frac{{{}}}{{{}}}", numerator, denominator);
    }
    return fmt::format(fmt::runtime(product ? "{}/({})" : "{}/{}"), numerator, denominator);
}

/// Words with spaces between them, without empty ones.
std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() || word.empty() ? "" : " ") + word;
    }
    return text;
}

std::string product(const std::vector<Factor>& factors, Notation notation) {
    std::string text;
    for (const Factor& factor : factors) {
        const std::string base = formula(factor.polynomial, "n", notation);
        text += power(base == "n" ? base : "(" + base + ")", factor.power, notation);
    }
    return text;
}

/// -3n^2/4 and the like: p(n) G^g / n^below, its sign first.
std::string term(const Polynomial& in_n, std::size_t g, std::size_t below, Notation notation) {
    const Factors factors = factors_of(in_n);
    const Integer above = abs(numerator(factors.content));
    const Integer under = denominator(factors.content);
    const bool only_factor = g == 0 && above == 1 && factors.factors.size() == 1 &&
                             factors.factors[0].power == 1 &&
                             (notation == Notation::latex || under == 1);
    const std::string rest = only_factor ? formula(factors.factors[0].polynomial, "n", notation)
                                         : product(factors.factors, notation);
    const bool said = g > 0 || !rest.empty();
    const std::string numerator =
        joined({above == 1 && said ? "" : above.str(), power("G", g, notation), rest});
    const std::string denominator =
        joined({under == 1 ? "" : under.str(), power("n", below, notation)});
    return (factors.content < 0 ? "- " : "+ ") +
           fraction(numerator, denominator, under != 1 && below > 0, notation);
}

}  // namespace

std::string formula(const IntegerPolynomial& polynomial, std::string_view letter,
                    Notation notation) {
    std::string text;
    for (std::size_t k = polynomial.size(); k-- > 0;) {
        if (polynomial[k] == 0) {
            continue;
        }
        const bool negative = polynomial[k] < 0;
        const Integer size = abs(polynomial[k]);
        text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
        text += (size == 1 && k > 0 ? "" : size.str()) + power(letter, k, notation);
    }
    return text.empty() ? "0" : text;
}

std::vector<std::string> terms(const ClosedForm& function, unsigned pole, Notation notation) {
    std::vector<std::string> result;
    for (std::size_t g = 0; g < function.size(); ++g) {
        if (!function[g].is_zero()) {
            result.push_back(term(function[g], g, pole * g, notation));
        }
    }
    return result;
}

std::string value(const AlgebraicNumber& number, std::string_view letter, Notation notation) {
    const bool latex = notation == Notation::latex;
    const std::string digits = fmt::format("{:.10g}", nearest_double(number));
    const std::string exact = to_text(number);
    if (exact.empty()) {
        return fmt::format(
            fmt::runtime(latex ? "\\approx {}, \\quad {} = 0" : "= {}, a root of {} = 0"), digits,
            formula(number.polynomial, letter, notation));
    }
    if (latex) {
        static const std::regex root(R"(\*?sqrt\((\d+)\))");
        return "= " + std::regex_replace(exact, root, "\\sqrt{$1}");
    }
    return "= " + exact + (exact == digits ? "" : " = " + digits);
}

std::string equation(const std::vector<Polynomial>& in_W, Notation notation) {
    std::string text;
    for (std::size_t k = in_W.size(); k-- > 0;) {
        if (in_W[k].is_zero()) {
            continue;
        }
        const bool negative = !text.empty() && in_W[k].data().back() < 0;
        const std::string coefficient =
            formula(to_rational_function(negative ? -in_W[k] : in_W[k]).numerator, "G", notation);
        text +=
            (text.empty() ? ""
             : negative   ? " - "
                          : " + ") +
            (coefficient.find(' ') == std::string::npos ? coefficient : "(" + coefficient + ")") +
            (k == 0 ? "" : " " + power("W", k, notation));
    }
    return text + " = 0";
}

}  // namespace nmbcgen
