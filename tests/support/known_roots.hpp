// SPDX-License-Identifier: GPL-2.0-or-later
/// Polynomials with known roots, and what real roots found of them have to satisfy.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "generator/exact/algebraic_number.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/exact/real_roots.hpp"
#include "tests/support/generators.hpp"

namespace nmbcgen::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline const Rational everywhere = -Rational(pow(Integer(10), 30));

inline Polynomial poly(std::vector<Rational> coefficients) {
    return {std::move(coefficients)};
}

inline Polynomial linear(const Rational& root) {
    return poly({-root, 1});
}

using Texts = std::vector<std::string>;

inline Texts texts(const std::vector<AlgebraicNumber>& numbers) {
    Texts result(numbers.size());
    std::ranges::transform(numbers, result.begin(), to_text);
    return result;
}

inline bool equal(const AlgebraicNumber& left, const AlgebraicNumber& right) {
    return std::is_eq(compare(left, right));
}

/// The number lies within half a unit in the last place, as its polynomial's signs there tell.
inline bool rounded_correctly(const AlgebraicNumber& number) {
    const double value = nearest_double(number);
    if (number.low == number.high) {
        return value == nearest_double(number.low);
    }
    const auto half_way = [value](double towards) {
        return Rational((Rational(value) + Rational(std::nextafter(value, towards))) / 2);
    };
    // No further than the interval, so that a change of sign is this root's.
    const Rational from = std::max(half_way(-infinity), number.low);
    const Rational to = std::min(half_way(infinity), number.high);
    const Polynomial f = over_rationals(number.polynomial);
    return from < to && evaluate(f, from) * evaluate(f, to) < 0;
}

/// What AlgebraicNumber promises.
inline bool well_formed(const AlgebraicNumber& number) {
    const auto& coefficients = number.polynomial.data();
    Integer content = 0;
    for (const Integer& coefficient : coefficients) {
        content = gcd(content, coefficient);
    }
    const Polynomial f = over_rationals(number.polynomial);
    const bool rational = number.low == number.high;
    return content == 1 && coefficients.back() > 0 &&
           rational == (number.polynomial.degree() == 1) && square_free(f) == f &&
           count_real_roots(f, number.low, number.high) == 1 &&
           (rational || evaluate(f, number.low) * evaluate(f, number.high) < 0);
}

/// All of them, ascending and disjoint.
inline bool all_well_formed(const std::vector<AlgebraicNumber>& numbers) {
    const auto meet = [](const auto& left, const auto& right) { return left.high >= right.low; };
    return std::ranges::adjacent_find(numbers, meet) == numbers.end() &&
           std::ranges::all_of(numbers, well_formed);
}

/// A root known by construction: centre + branch * radicand^(1/degree).
struct KnownRoot {
    Rational centre;
    unsigned degree = 1;
    Rational radicand = 0;
    int branch = 1;  ///< of the square root

    /// (x - centre)^degree - radicand
    Polynomial factor() const {
        Polynomial power = constant(1);
        for (unsigned k = 0; k < degree; ++k) {
            power *= linear(centre);
        }
        return power - constant(radicand);
    }

    /// The sign of the root minus x, by powers of x - centre alone.
    int minus(const Rational& x) const {
        const Rational d = x - centre;
        if (degree != 2) {
            return Rational(radicand - (degree == 1 ? d : Rational(d * d * d))).sign();
        }
        return branch * d <= 0 ? branch : branch * Rational(radicand - d * d).sign();
    }
};

/// A polynomial made of known factors, of random multiplicity.
struct Construction {
    Polynomial polynomial = constant(1);
    std::vector<KnownRoot> roots;

    void multiply(const KnownRoot& root) {
        if ((polynomial % root.factor()).is_zero()) {
            return;
        }
        const bool complex = root.degree == 2 && root.radicand < 0;
        for (const int branch : {-1, 1}) {
            if (!complex && (branch == 1 || root.degree == 2)) {
                roots.push_back(root);
                roots.back().branch = branch;
            }
        }
        for (int k = *rc::gen::inRange(1, 3); k > 0; --k) {
            polynomial *= root.factor() * constant(*rc::gen::inRange(1, 4));
        }
    }
};

/// Radicands of which neither the square nor the cube root is rational; x^2 = -1 is irreducible.
inline Rational random_radicand() {
    return *rc::gen::element(2, 3, 5, 6, 12, 18, 99991, -1, -2) *
           *rc::gen::element(Rational(1), Rational(1, 25), Rational(9, 49));
}

inline Construction construct() {
    Construction result;
    for (int k = *rc::gen::inRange(0, 4); k > 0; --k) {
        result.multiply({*small_rational()});
    }
    for (int k = *rc::gen::inRange(0, 4); k > 0; --k) {
        result.multiply({*small_rational(), 2, random_radicand()});
    }
    for (int k = *rc::gen::inRange(0, 3); k > 0; --k) {
        result.multiply({*small_rational(), 3, 2 * *rc::gen::inRange(1, 4)});
    }
    return result;
}

/// The one of the known roots that the interval holds.
inline const KnownRoot& identify(const AlgebraicNumber& found,
                                 const std::vector<KnownRoot>& known) {
    const auto held = [&found](const KnownRoot& root) {
        return root.minus(found.low) >= 0 && root.minus(found.high) <= 0;
    };
    RC_ASSERT(std::ranges::count_if(known, held) == 1);
    return *std::ranges::find_if(known, held);
}

}  // namespace nmbcgen::test
