// SPDX-License-Identifier: GPL-2.0-or-later
/// Operations on algebraic numbers, on roots known by construction.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "tests/support/known_roots.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

TEST_CASE("comparisons are exact") {
    CHECK(rc::check("with the roots of a multiple of the polynomial", [] {
        const Construction made = construct();
        Construction more = made;
        more.multiply({*small_rational(), 3, 7});
        more.multiply({*small_rational(), 2, 7});
        const auto few = real_roots(made.polynomial, everywhere);
        const auto many = real_roots(more.polynomial, everywhere);
        std::size_t j = 0;
        for (const AlgebraicNumber& number : few) {
            for (; j < many.size() && !equal(number, many[j]); ++j) {
                RC_ASSERT(std::is_gt(compare(number, many[j])));
            }
            RC_ASSERT(j < many.size());
            for (std::size_t after = j + 1; after < many.size(); ++after) {
                RC_ASSERT(std::is_lt(compare(number, many[after])));
            }
        }
    }));
    CHECK(rc::check("with a rational", [] {
        const Construction made = construct();
        const Rational x = *small_rational();
        for (const AlgebraicNumber& number : real_roots(made.polynomial, everywhere)) {
            const int sign = identify(number, made.roots).minus(x);
            RC_ASSERT(compare(number, x) == sign <=> 0);
            RC_ASSERT(compare(number, to_algebraic_number(x)) == sign <=> 0);
        }
    }));
    CHECK(rc::check("the sign of a polynomial at a quadratic number", [] {
        const KnownRoot known{*small_rational(), 2, *rc::gen::element(2, 3, 75)};
        const auto number = real_roots(known.factor(), known.centre).at(0);
        const Polynomial p = *polynomial(6);
        const Polynomial rest = p % known.factor();  // u + v x at the number
        const Rational u = rest.size() > 0 ? rest[0] : Rational(0);
        const Rational v = rest.size() > 1 ? rest[1] : Rational(0);
        RC_ASSERT(sign_at(p, number) == (v == 0 ? u.sign() : v.sign() * known.minus(-u / v)));
        RC_ASSERT(sign_at(p * known.factor(), number) == 0);
    }));
}

TEST_CASE("refinement keeps the number and gives the width") {
    CHECK(rc::check([] {
        const Construction made = construct();
        for (const AlgebraicNumber& number : real_roots(made.polynomial, everywhere)) {
            const Rational width(1, pow(Integer(10), *rc::gen::inRange(0U, 200U)));
            AlgebraicNumber narrow = number;
            refine(narrow, width);
            RC_ASSERT(narrow.high - narrow.low <= width);
            RC_ASSERT(number.low <= narrow.low && narrow.high <= number.high);
            RC_ASSERT(well_formed(narrow));
        }
    }));
    AlgebraicNumber number = real_roots(poly({-2, 0, 1}), 0).at(0);
    CHECK_THROWS_AS(refine(number, 0), std::invalid_argument);
}

TEST_CASE("rationals between") {
    CHECK(rc::check("the simplest between two rationals", [] {
        const Rational a = *small_rational();
        const Rational b = *small_rational();
        RC_PRE(a != b);
        const auto low = std::min(a, b);
        const auto high = std::max(a, b);
        const Rational found = rational_between(to_algebraic_number(a), to_algebraic_number(b));
        RC_ASSERT(low < found && found < high);
        for (Integer q = 1; q <= denominator(found); ++q) {
            for (Integer p = -20 * q; p <= 20 * q; ++p) {
                const Rational other(p, q);
                const bool between = low < other && other < high;
                RC_ASSERT(!between || denominator(other) > denominator(found) ||
                          abs(other) >= abs(found));
                RC_ASSERT(!between || q == denominator(found) || denominator(found) == 1);
            }
        }
    }));
    CHECK(rc::check("any two roots, whatever their intervals", [] {
        const auto roots = real_roots(construct().polynomial, everywhere);
        for (std::size_t i = 0; i + 1 < roots.size(); ++i) {
            const Rational found = rational_between(roots[i], roots[i + 1]);
            RC_ASSERT(std::is_lt(compare(roots[i], found)));
            RC_ASSERT(std::is_gt(compare(roots[i + 1], found)));
            AlgebraicNumber narrow = roots[i];
            refine(narrow, Rational(1, pow(Integer(10), 30)));
            RC_ASSERT(rational_between(roots[i + 1], narrow) == found);
        }
        if (!roots.empty()) {
            const Rational above = rational_above(roots.back());
            RC_ASSERT(std::is_lt(compare(roots.back(), above)));
            RC_ASSERT(above == 0 || std::is_gteq(compare(roots.back(), above - 1)));
            CHECK_THROWS_AS(rational_between(roots[0], roots[0]), std::invalid_argument);
        }
    }));
    CHECK(rational_above(to_algebraic_number(3)) == 4);
    CHECK(rational_above(to_algebraic_number(Rational(-7, 2))) == 0);
    CHECK(rational_between(to_algebraic_number(0), to_algebraic_number(Rational(2, 7))) ==
          Rational(1, 4));
}

TEST_CASE("radicals are written in lowest terms") {
    CHECK(rc::check([] {
        const int p = *rc::gen::inRange(-30, 31);
        const int s = *rc::gen::inRange(2, 30);
        const int q = *rc::gen::inRange(2, 30);
        const int d = *rc::gen::element(2, 3, 5, 6, 7, 10, 433, 1000003);
        RC_PRE(std::gcd(std::gcd(p, s), q) == 1 && p != 0);
        // x = (p - s sqrt(d))/q: (q x - p)^2 = s^2 d
        const auto numbers =
            real_roots(poly({-p, q}) * poly({-p, q}) - constant(Rational(s) * s * d), everywhere);
        const std::string root = std::to_string(s) + "*sqrt(" + std::to_string(d) + "))/";
        const std::string whole = "(" + std::to_string(p);
        const Texts expected{whole + " - " + root + std::to_string(q),
                             whole + " + " + root + std::to_string(q)};
        RC_ASSERT(texts(numbers) == expected);
    }));
}
