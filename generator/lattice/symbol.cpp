// SPDX-License-Identifier: MIT
#include "generator/lattice/symbol.hpp"

#include <algorithm>
#include <stdexcept>

#include "generator/exact/rational_function.hpp"
#include "generator/exact/real_roots.hpp"

namespace nmbcgen {

namespace {

/// From the first to the last entry that is not zero, whatever the weight.
std::size_t width(const std::vector<Rational>& stencil) {
    const auto is_set = [](const Rational& entry) { return entry != 0; };
    const auto first = std::ranges::find_if(stencil, is_set);
    const auto last = std::find_if(stencil.rbegin(), stencil.rend(), is_set);
    return first == stencil.end() ? 0 : std::size_t(last.base() - first);
}

/// Times their common denominator: sums of products of whole numbers are many times faster.
struct WholeNumbers {
    std::vector<Integer> entries;
    Integer denominator = 1;
};

WholeNumbers whole_numbers(const std::vector<Rational>& stencil) {
    WholeNumbers whole;
    for (const Rational& entry : stencil) {
        whole.denominator = lcm(whole.denominator, denominator(entry));
    }
    for (const Rational& entry : stencil) {
        whole.entries.push_back(numerator(entry) * (whole.denominator / denominator(entry)));
    }
    return whole;
}

}  // namespace

std::vector<Polynomial> symbol_of(std::span<const ExactSquare> energy) {
    if (energy.empty()) {
        throw std::logic_error("a lattice model needs an energy");
    }
    std::size_t widest = 0;
    for (const ExactSquare& square : energy) {
        widest = std::max(widest, width(square.stencil));
    }
    std::vector<Polynomial> symbol(widest);
    for (const ExactSquare& square : energy) {
        const auto [entries, divisor] = whole_numbers(square.stencil);
        for (std::size_t m = 0; m < std::min(widest, entries.size()); ++m) {
            Integer autocorrelation = 0;
            for (std::size_t i = 0; i + m < entries.size(); ++i) {
                autocorrelation += entries[i] * entries[i + m];
            }
            symbol[m] +=
                square.weight * constant(Rational(autocorrelation, Integer(divisor * divisor)));
        }
    }
    return symbol;
}

bool is_positive(const std::vector<Polynomial>& symbol) {
    // In x = cos(xi), on -1 <= x <= 1; 1 - x divides it.
    const Polynomial x{0, 1};
    Polynomial before = constant(1);  // cos((m - 1) xi), cos(m xi)
    Polynomial cosine = x;
    Polynomial omega_squared = symbol[0];
    for (std::size_t m = 1; m < symbol.size(); ++m) {
        omega_squared += symbol[m] * cosine * constant(2);
        const Polynomial next = x * cosine * constant(2) - before;
        before = cosine;
        cosine = next;
    }
    const Polynomial over_long_waves = omega_squared / Polynomial{1, -1};
    return evaluate(over_long_waves, 1) > 0 && count_real_roots(over_long_waves, -1, 1) == 0;
}

std::vector<Polynomial> symbol_of(const Table& table) {
    std::vector<Polynomial> symbol = table.model.symbol;
    if (const auto& G = table.specification.stabilisation) {
        for (Polynomial& coefficient : symbol) {
            coefficient = constant(evaluate(coefficient, *G));
        }
    }
    return symbol;
}

}  // namespace nmbcgen
