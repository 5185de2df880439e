// SPDX-License-Identifier: GPL-2.0-or-later
/// The normal form of rational functions, on random instances.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <stdexcept>
#include <vector>

#include "generator/exact/rational_function.hpp"
#include "tests/support/generators.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

/// Greatest common divisor of all coefficients of both polynomials.
Integer joint_content(const ExactFunction& f) {
    Integer content = 0;
    for (const IntegerPolynomial* polynomial : {&f.numerator, &f.denominator}) {
        for (const Integer& coefficient : polynomial->data()) {
            content = gcd(content, coefficient);
        }
    }
    return content;
}

/// Degree of the greatest common divisor, by Euclid's algorithm over Q (the library uses
/// subresultants over Z).
std::size_t common_degree(Polynomial left, Polynomial right) {
    while (!right.is_zero()) {
        const Polynomial remainder = boost::math::tools::quotient_remainder(left, right).second;
        left = right;
        right = remainder;
    }
    return left.degree();
}

void assert_normal(const ExactFunction& f) {
    RC_ASSERT(joint_content(f) == 1);
    RC_ASSERT(f.denominator.data().back() > 0);
    RC_ASSERT(common_degree(over_rationals(f.denominator), over_rationals(f.numerator)) == 0U);
}

/// Numerator, denominator and a factor to hide in both.
struct Fraction {
    Polynomial top = *polynomial(4);
    Polynomial bottom = *nonzero_polynomial(4);
    Polynomial factor = *nonzero_polynomial(3);
    ExactFunction reduced = reduce(top * factor, bottom* factor);
};

}  // namespace

TEST_CASE("binomials: Pascal's rows, with signs or without") {
    CHECK(binomial(1, 0).data() == std::vector<Integer>{1});
    CHECK(binomial(1, 4).data() == std::vector<Integer>{1, 4, 6, 4, 1});
    CHECK(binomial(-1, 5).data() == std::vector<Integer>{1, -5, 10, -10, 5, -1});
    for (const int sign : {1, -1}) {  // 84 choose 42 is beyond 64 bits
        CHECK(binomial(sign, 84) == binomial(sign, 42) * binomial(sign, 42));
    }
}

TEST_CASE("fixed answers") {
    const auto p = [](std::vector<Rational> c) { return Polynomial(std::move(c)); };
    const auto z = [](std::vector<Integer> c) { return IntegerPolynomial(std::move(c)); };
    // (G^2 - 1)/(2G - 2) = (G + 1)/2
    CHECK(reduce(p({-1, 0, 1}), p({-2, 2})) == ExactFunction{z({1, 1}), z({2})});
    // (1/2 + G/3)/(-1/4) = -(6 + 4G)/3
    CHECK(reduce(p({Rational(1, 2), Rational(1, 3)}), p({Rational(-1, 4)})) ==
          ExactFunction{z({-6, -4}), z({3})});
    // The sign stands in the numerator: 1/(1 - G) = -1/(G - 1)
    CHECK(reduce(p({1}), p({1, -1})) == ExactFunction{z({-1}), z({-1, 1})});
    // Zero is 0/1, whatever it was divided by.
    CHECK(reduce(Polynomial(), p({3, 7})) == ExactFunction{IntegerPolynomial(), z({1})});
    CHECK_THROWS_AS(reduce(p({1}), Polynomial()), std::domain_error);
    CHECK(to_rational_function(p({Rational(1, 4), Rational(-1, 6)})) ==
          ExactFunction{z({3, -2}), z({12})});
}

TEST_CASE("reduce gives a normal form") {
    CHECK(rc::check("integers without common factor, coprime, leading denominator positive",
                    [] { assert_normal(Fraction().reduced); }));
    CHECK(rc::check("the same value everywhere", [] {
        const Fraction f;
        const Rational G = *small_rational();
        const Rational bottom = evaluate(f.bottom, G);
        RC_PRE(bottom != 0);
        // Coprime, and so without a zero of its own where the function has a value.
        RC_ASSERT(evaluate(over_rationals(f.reduced.denominator), G) != 0);
        RC_ASSERT(evaluate(over_rationals(f.reduced.numerator), G) * bottom ==
                  evaluate(f.top, G) * evaluate(over_rationals(f.reduced.denominator), G));
    }));
    CHECK(rc::check("unique: a common factor does not show", [] {
        const Fraction f;
        RC_ASSERT(f.reduced == reduce(f.top, f.bottom));
    }));
    CHECK(rc::check("idempotent", [] {
        const ExactFunction f = Fraction().reduced;
        RC_ASSERT(f == reduce(over_rationals(f.numerator), over_rationals(f.denominator)));
    }));
    CHECK(rc::check("a polynomial keeps its coefficients", [] {
        const Polynomial p = *polynomial(5);
        const ExactFunction f = to_rational_function(p);
        assert_normal(f);
        RC_ASSERT(f.denominator.degree() == 0U);
        RC_ASSERT(over_rationals(f.numerator) == p * constant(Rational(f.denominator[0])));
    }));
}

TEST_CASE("a common denominator clears every fraction") {
    CHECK(rc::check([] {
        const std::vector<ExactFunction> functions{Fraction().reduced, Fraction().reduced,
                                                   Fraction().reduced};
        const Polynomial common = common_denominator(functions);
        RC_ASSERT(!common.is_zero());
        for (const ExactFunction& f : functions) {
            // f * common = p as polynomials: numerator * common = p * denominator.
            RC_ASSERT(over_rationals(f.numerator) * common ==
                      times_multiple(f, common) * over_rationals(f.denominator));
        }
    }));
    // (1/(G + 1)) * (G + 2) is no polynomial.
    const ExactFunction f = reduce(constant(1), Polynomial(std::vector<Rational>{1, 1}));
    CHECK_THROWS_AS(times_multiple(f, Polynomial(std::vector<Rational>{2, 1})), std::logic_error);
}
