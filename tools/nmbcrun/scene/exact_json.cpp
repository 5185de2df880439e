// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/exact_json.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "generator/exact/rational.hpp"

namespace nmbcrun {
namespace {

constexpr std::size_t most_digits = 4000;

bool is_integer(std::string_view text) {
    const std::string_view digits = text.substr(text.starts_with('-') ? 1 : 0);
    return !digits.empty() && digits.size() <= most_digits &&
           std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; }) &&
           (digits.front() != '0' || text == "0");
}

bool is_positive_integer(std::string_view text) {
    return is_integer(text) && text.front() != '-' && text != "0";
}

std::optional<Fraction> fraction_in(std::string_view text) {
    const std::size_t slash = std::min(text.find('/'), text.size());
    Fraction fraction{std::string(text.substr(0, slash)),
                      slash == text.size() ? "1" : std::string(text.substr(slash + 1))};
    return is_integer(fraction.numerator) && is_positive_integer(fraction.denominator)
               ? std::optional(std::move(fraction))
               : std::nullopt;
}

std::optional<nmbcgen::Rational> in_lowest_terms(const std::string& text) {
    const auto fraction = fraction_in(text);
    if (!fraction) {
        return std::nullopt;
    }
    nmbcgen::Rational value = fraction->value();
    return nmbcgen::to_string(value) == text ? std::optional(std::move(value)) : std::nullopt;
}

std::string integers_of(const JsonValue& json) {
    std::string list;
    for (const JsonValue& element : json.elements()) {
        const std::string text = element.text();
        if (!is_integer(text)) {
            element.must_be("an integer in a string");
        }
        list += (list.empty() ? "" : " ") + text;
    }
    if (list.empty()) {
        json.must_be("a list of one integer or more");
    }
    return list;
}

}  // namespace

nmbcgen::Rational Fraction::value() const {
    return {nmbcgen::Integer(numerator), nmbcgen::Integer(denominator)};
}

Fraction fraction_of(const JsonValue& json) {
    auto fraction = fraction_in(json.text());
    if (!fraction) {
        json.must_be(R"(an exact number "p/q" or "p")");
    }
    return *std::move(fraction);
}

Fraction rational_function_of(const JsonValue& json) {
    const JsonValue below = json.at("den");
    Fraction function{integers_of(json.at("num")), integers_of(below)};
    const std::string_view denominator = function.denominator;
    const std::size_t last_space = denominator.find_last_of(' ');
    if (!is_positive_integer(
            denominator.substr(last_space == std::string_view::npos ? 0 : last_space + 1))) {
        below.must_be("a list of integers of which the last is positive");
    }
    return function;
}

nmbcgen::Rational number_of(const JsonValue& json) {
    const auto value = in_lowest_terms(json.text());
    if (!value) {
        json.must_be("an exact number \"p/q\" in lowest terms");
    }
    return *value;
}

nmbcgen::Rational parameter_of(const JsonValue& json) {
    const auto value = in_lowest_terms(json.text());
    if (!value || *value < 0) {
        json.must_be("an exact number \"p/q\" in lowest terms, not below 0");
    }
    return *value;
}

}  // namespace nmbcrun
