// SPDX-License-Identifier: MIT
#include "generator/stability/scalar.hpp"

#include <stdexcept>

#include "generator/exact/algebraic_number.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/exact/real_roots.hpp"
#include "generator/stability/critical_values.hpp"

namespace nmbcgen {
namespace {

using InW = std::vector<Polynomial>;  // ascending in w, coefficients in Q[G]

Polynomial at(const InW& polynomial, const Rational& G) {
    std::vector<Rational> coefficients;
    for (const Polynomial& coefficient : polynomial) {
        coefficients.push_back(evaluate(coefficient, G));
    }
    return Polynomial(std::move(coefficients));
}

/// Whether the polynomial is not negative for all w < 0.
bool not_negative_below_zero(const Polynomial& in_w) {
    std::vector<Rational> mirrored;  // in -w
    for (std::size_t i = 0; i < in_w.size(); ++i) {
        mirrored.push_back(i % 2 == 0 ? in_w[i] : Rational(-in_w[i]));
    }
    const Polynomial f(std::move(mirrored));
    const auto roots = real_roots(f, 0);
    AlgebraicNumber previous = to_algebraic_number(0);
    for (const AlgebraicNumber& root : roots) {
        if (compare(root, previous) != 0 && evaluate(f, rational_between(previous, root)) < 0) {
            return false;
        }
        previous = root;
    }
    return evaluate(f, rational_above(previous)) >= 0;
}

}  // namespace

bool scalar_reflection_is_bounded(const HalfSpace& half_space) {
    return not_negative_below_zero(half_space.E * half_space.O);
}

std::vector<ExactWindow> scalar_windows(const Table& table) {
    if (table.specification.stabilisation) {
        throw std::invalid_argument("scalar_windows: the table is for one value of G only");
    }
    std::vector<ExactWindow> windows;
    if (table.specification.stride != 1) {
        return windows;
    }
    const EvenAndOddParts parts = even_and_odd_parts(table);
    const auto critical = scalar_critical_values(parts);
    AlgebraicNumber low = to_algebraic_number(0);
    bool inside = false;
    for (std::size_t i = 0; i <= critical.size(); ++i) {
        const AlgebraicNumber& begin = i == 0 ? low : critical[i - 1];
        const Rational sample =
            i < critical.size() ? rational_between(begin, critical[i]) : rational_above(begin);
        const bool holds = not_negative_below_zero(at(parts.E, sample) * at(parts.O, sample));
        if (holds && !inside) {
            low = begin;
        } else if (!holds && inside) {
            windows.push_back({low, begin});
        }
        inside = holds;
    }
    if (inside) {
        windows.push_back({low, std::nullopt});
    }
    return windows;
}

}  // namespace nmbcgen
