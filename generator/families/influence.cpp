// SPDX-License-Identifier: MIT
#include "generator/families/influence.hpp"

#include <algorithm>
#include <array>

namespace nmbcgen {
namespace {

Rational constant_influence(unsigned /*m*/, unsigned /*horizon*/) {
    return 1;
}

/// Of m/(n + 1), so that the longest bonds still count.
Rational conical(unsigned m, unsigned horizon) {
    return {horizon + 1 - m, horizon + 1};
}

Rational inverse(unsigned m, unsigned /*horizon*/) {
    return {1, m};
}

/// (1 - x)^2 (1 + 2x), x = m/(n + 1): smooth at both ends.
Rational cubic(unsigned m, unsigned horizon) {
    const Rational x(m, horizon + 1);
    return (1 - x) * (1 - x) * (1 + 2 * x);
}

}  // namespace

std::span<const Influence> influences() {
    static constexpr std::array list{
        Influence{"constant", constant_influence},
        Influence{"conical", conical},
        Influence{"inverse", inverse},
        Influence{"cubic", cubic},
    };
    return list;
}

std::vector<Rational> weights_of(const Influence& influence, unsigned horizon) {
    std::vector<Rational> weights;
    for (unsigned m = 1; m <= horizon; ++m) {
        weights.push_back(influence.weight(m, horizon));
    }
    return weights;
}

std::vector<Rational> normalised(std::vector<Rational> weights) {
    const Rational first = abs(weights.front());
    for (Rational& weight : weights) {
        weight /= first;
    }
    const bool constant = std::ranges::all_of(weights, [](const Rational& w) { return w == 1; });
    return constant ? std::vector<Rational>() : weights;
}

}  // namespace nmbcgen
