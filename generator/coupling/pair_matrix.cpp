// SPDX-License-Identifier: MIT
#include "generator/coupling/pair_matrix.hpp"

#include <algorithm>
#include <stdexcept>

namespace nmbcgen {
namespace {

/// constant + of_x x + of_s s, s = x' - x.
struct Linear {
    Rational constant;
    Rational of_x;
    Rational of_s;

    Polynomial at_fixed_x() const { return Polynomial{constant, of_s}; }
};

Linear operator*(const Rational& factor, const Linear& function) {
    return {factor * function.constant, factor * function.of_x, factor * function.of_s};
}

/// The hat functions of a pair's nodes.
struct Hats {
    std::vector<Linear> at_x;
    std::vector<Linear> differences;  ///< at x' less at x
};

Hats hats_of(const ElementPair& pair) {
    const Rational slope = 1 / pair.length;
    const std::vector<Linear> own{{1, -slope, 0}, {0, slope, 0}};
    if (pair.gap == 0) {
        return {own, {{0, 0, -slope}, {0, 0, slope}}};
    }
    const Rational other = 1 / pair.other_length;
    const Rational offset = pair.gap * other;
    return {{own[0], own[1], {}, {}},
            {-1 * own[0], -1 * own[1], {1 + offset, -other, -other}, {-offset, other, other}}};
}

/// Where x may be at a given s: both ends are linear in s.
struct Range {
    Polynomial from;
    Polynomial to;
};

Range range_at(const ElementPair& pair, const Rational& s) {
    const bool cut_below = pair.gap - s > 0;
    const bool cut_above = pair.gap + pair.other_length - s < pair.length;
    return {cut_below ? Polynomial{pair.gap, -1} : Polynomial{},
            cut_above ? Polynomial{pair.gap + pair.other_length, -1} : Polynomial{pair.length}};
}

/// int one other dx over the range, as a polynomial of s.
Polynomial inner_integral(const Linear& one, const Linear& other, const Range& range) {
    const Polynomial a = one.at_fixed_x();
    const Polynomial b = other.at_fixed_x();
    const Polynomial mixed = a * other.of_x + b * one.of_x;
    const Polynomial to2 = range.to * range.to;
    const Polynomial from2 = range.from * range.from;
    return a * b * (range.to - range.from) + mixed * (to2 - from2) * Rational(1, 2) +
           (to2 * range.to - from2 * range.from) * Rational(one.of_x * other.of_x / 3);
}

/// int integrand/|s| ds over an interval on one side of 0. Towards s = 0 either a pair has no place
/// or its differences vanish.
LogNumber over_distance(const Polynomial& integrand, const Rational& from, const Rational& to) {
    LogNumber sum;
    if (integrand.is_zero()) {
        return sum;
    }
    Rational to_power = 1;
    Rational from_power = 1;
    for (std::size_t n = 1; n < integrand.size(); ++n) {
        to_power *= to;
        from_power *= from;
        sum.rational += integrand[n] * (to_power - from_power) / Rational(n);
    }
    if (to <= 0) {
        sum.rational = -sum.rational;
    }
    if (integrand[0] != 0) {
        if (from == 0 || to == 0) {
            throw std::logic_error("an integral over pairs has no value");
        }
        // From the end next to 0 to the other one.
        sum += integrand[0] * log_of(from > 0 ? to : Rational(-from));
        sum += -integrand[0] * log_of(from > 0 ? from : Rational(-to));
    }
    return sum;
}

/// Where the range of x changes its form, within the horizon.
std::vector<Rational> breakpoints(const ElementPair& pair) {
    const Rational& delta = pair.horizon;
    std::vector<Rational> all{-delta,
                              pair.gap - pair.length,
                              pair.gap,
                              pair.gap + pair.other_length - pair.length,
                              pair.gap + pair.other_length,
                              0,
                              delta};
    const Rational first = std::max(-delta, all[1]);
    const Rational last = std::min(delta, all[4]);
    std::erase_if(all, [&](const Rational& s) { return s < first || s > last; });
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}  // namespace

std::vector<LogNumber> pair_matrix(const ElementPair& pair, CouplingForm form) {
    const Hats hats = hats_of(pair);
    const std::size_t size = hats.differences.size();
    // c = 2/(delta^2 |s|)
    const Rational factor = (form == CouplingForm::pairs ? 1 : -2) / (pair.horizon * pair.horizon);
    const std::vector<Linear>& tests = form == CouplingForm::pairs ? hats.differences : hats.at_x;
    const std::vector<Rational> s = breakpoints(pair);
    std::vector<LogNumber> matrix(size * size);
    for (std::size_t piece = 1; piece < s.size(); ++piece) {
        const Range range = range_at(pair, (s[piece - 1] + s[piece]) / 2);
        for (std::size_t i = 0; i < size * size; ++i) {
            const Polynomial integrand =
                inner_integral(tests[i / size], hats.differences[i % size], range);
            matrix[i] += factor * over_distance(integrand, s[piece - 1], s[piece]);
        }
    }
    return matrix;
}

}  // namespace nmbcgen
