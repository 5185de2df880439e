// SPDX-License-Identifier: MIT
#include "generator/exact/factors.hpp"

#include <algorithm>
#include <stdexcept>

#include "generator/exact/rational_function.hpp"
#include "generator/exact/real_roots.hpp"
#include "generator/exact/sturm.hpp"

namespace nmbcgen {
namespace {

bool before(const Factor& left, const Factor& right) {
    const auto& one = left.polynomial.data();
    const auto& other = right.polynomial.data();
    return one.size() != other.size() ? one.size() < other.size()
                                      : std::lexicographical_compare(one.rbegin(), one.rend(),
                                                                     other.rbegin(), other.rend());
}

/// A number below all real roots: Cauchy's bound is 1 + max |a_i / a_n|, and |a_n| >= 1.
Rational below_all_roots(const IntegerPolynomial& polynomial) {
    Integer sum = 0;
    for (const Integer& coefficient : polynomial.data()) {
        sum -= abs(coefficient);
    }
    return sum;
}

/// Divides the polynomial by the factor as often as that leaves no remainder.
unsigned divide_out(Polynomial& polynomial, const Polynomial& factor) {
    unsigned power = 0;
    for (; (polynomial % factor).is_zero(); ++power) {
        polynomial /= factor;
    }
    return power;
}

}  // namespace

Factors factors_of(const Polynomial& polynomial) {
    if (polynomial.is_zero()) {
        throw std::domain_error("0 has no factors");
    }
    const IntegerPolynomial whole = primitive(polynomial);
    if (whole.degree() == 0) {
        return {polynomial[0], {}};
    }
    Factors result{polynomial.data().back() / whole.data().back(), {}};
    Polynomial rest = over_rationals(whole);
    for (const AlgebraicNumber& root : real_roots(polynomial, below_all_roots(whole))) {
        if (root.polynomial.degree() <= 2) {
            // The second root of a quadratic factor finds it divided out.
            const unsigned power = divide_out(rest, over_rationals(root.polynomial));
            if (power > 0) {
                result.factors.push_back({root.polynomial, power});
            }
        }
    }
    if (rest.size() > 1) {
        result.factors.push_back({primitive(rest), 1});
    }
    std::ranges::sort(result.factors, before);
    return result;
}

}  // namespace nmbcgen
