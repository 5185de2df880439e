// SPDX-License-Identifier: MIT
#include <algorithm>
#include <regex>

#include "generator/exact/rational.hpp"
#include "generator/names/names.hpp"

namespace nmbcgen {
namespace {

unsigned count(const std::string& digits) {
    return unsigned(std::stoul(digits));
}

/// PoQ; 0 where there is none.
Rational fraction(std::string text) {
    if (text.empty()) {
        return 0;
    }
    text[text.find('o')] = '/';
    return parse_rational(text);
}

/// What `read` makes of each match of the pattern.
template <class Value, class Read>
std::vector<Value> each(const std::string& text, const std::regex& pattern, Read read) {
    std::vector<Value> values;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern);
         match != std::sregex_iterator(); ++match) {
        values.push_back(read(*match));
    }
    return values;
}

std::vector<Rational> weights(const std::string& text) {
    static const std::regex pattern(R"(\d+o\d+)");
    return each<Rational>(text, pattern,
                          [](const std::smatch& match) { return fraction(match[0]); });
}

std::vector<MatchingPoint> points(const std::string& text) {
    static const std::regex pattern(R"(_at(pi)?(\d+o\d+)x(\d+))");
    return each<MatchingPoint>(text, pattern, [](const std::smatch& match) {
        return MatchingPoint{.wave_number = fraction(match[2]),
                             .of_pi = match[1].matched,
                             .multiplicity = count(match[3])};
    });
}

}  // namespace

std::optional<Specification> specification_named(const std::string& name) {
    // More than two digits of order or horizon are no table that anybody could have made.
    static const std::regex pattern(
        R"((\w+?)_n([1-9]\d?)((?:_w(?:_\d+o\d+)+)?)_order([1-9]\d?)(?:_s([1-9]\d?))?)"
        R"((?:_tau(\d+o\d+))?(?:_dt(\d+o\d+))?((?:_at(?:pi)?\d+o\d+x[1-9]\d?)*)(?:_G(\d+o\d+))?)");
    std::smatch match;
    if (!std::regex_match(name, match, pattern)) {
        return std::nullopt;
    }
    Specification what{.family = match[1],
                       .horizon = count(match[2]),
                       .order = count(match[4]),
                       .stride = match[5].matched ? count(match[5]) : 1,
                       .stabilisation = {},
                       .damping = fraction(match[6]),
                       .time_step = fraction(match[7]),
                       .points = points(match[8]),
                       .weights = weights(match[3])};
    if (match[9].matched) {
        what.stabilisation = fraction(match[9]);
    }
    if (table_name(what) != name) {
        return std::nullopt;  // a number that is not in lowest terms
    }
    const auto is_one = [](const Rational& weight) { return weight == Rational(1); };
    if (!what.weights.empty() &&
        (!is_one(what.weights.front()) || std::ranges::all_of(what.weights, is_one))) {
        return std::nullopt;  // weights have w_1 = 1, and are said only where they differ
    }
    return what;
}

}  // namespace nmbcgen
