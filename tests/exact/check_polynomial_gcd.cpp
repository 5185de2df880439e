// SPDX-License-Identifier: GPL-2.0-or-later
/// Greatest common divisors: against the subresultant algorithm, and where primes are unlucky.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <boost/math/tools/polynomial_gcd.hpp>
#include <stdexcept>
#include <vector>

#include "generator/exact/polynomial_gcd.hpp"

using namespace nmbcgen;

namespace {

IntegerPolynomial random_polynomial(std::size_t most_terms, bool is_wide) {
    std::vector<Integer> coefficients;
    const auto terms = *rc::gen::inRange<std::size_t>(1, most_terms + 1);
    for (std::size_t i = 0; i < terms; ++i) {
        Integer coefficient = *rc::gen::inRange(-20, 21);
        for (int k = 0; is_wide && k < 4; ++k) {
            coefficient = coefficient * *rc::gen::inRange(1, 2'000'000'000) + 1;
        }
        coefficients.push_back(coefficient);
    }
    if (coefficients.back() == 0) {
        coefficients.back() = 1;
    }
    return IntegerPolynomial(coefficients);
}

/// Primitive, the leading coefficient positive.
IntegerPolynomial normal(IntegerPolynomial polynomial) {
    const Integer content = abs(boost::math::tools::content(polynomial));
    polynomial /= polynomial.data().back() < 0 ? Integer(-content) : content;
    return polynomial;
}

IntegerPolynomial of(std::vector<Integer> ascending) {
    return IntegerPolynomial(std::move(ascending));
}

}  // namespace

TEST_CASE("as the subresultant algorithm has it, whatever they share") {
    for (const bool is_wide : {false, true}) {
        CHECK(rc::check([is_wide] {
            const IntegerPolynomial shared = random_polynomial(5, is_wide);
            const IntegerPolynomial a = shared * random_polynomial(6, is_wide);
            const IntegerPolynomial b = shared * random_polynomial(6, is_wide);
            const IntegerPolynomial found = primitive_gcd(a, b);
            RC_ASSERT(found == normal(boost::math::tools::subresultant_gcd(a, b)));
            RC_ASSERT(found == primitive_gcd(b, a));
            RC_ASSERT(primitive_gcd(a, a) == normal(a));
        }));
    }
}

TEST_CASE("unlucky primes: those that divide a leading coefficient or make images too alike") {
    const Integer first = 2147483647;  // 2^31 - 1, the first prime that is tried
    const Integer second = 2147483629;
    // x + first and x are alike modulo the first prime, and have nothing in common.
    CHECK(primitive_gcd(of({first, 1}), of({0, 1})) == of({1}));
    CHECK(primitive_gcd(of({first * second, 1}), of({0, 1})) == of({1}));
    // A factor that is there is found behind them.
    const IntegerPolynomial shared = of({3, 7});
    CHECK(primitive_gcd(shared * of({first, 1}), shared * of({0, 1})) == shared);
    CHECK(primitive_gcd(shared * of({1, first}), shared * of({2, first})) == shared);
    CHECK(primitive_gcd(of({5, first}) * shared, of({5, first}) * of({1, 2})) == of({5, first}));
}

TEST_CASE("constants, content, signs and 0") {
    CHECK(primitive_gcd(of({6}), of({4})) == of({1}));
    CHECK(primitive_gcd(of({-6, -6}), of({4, 4})) == of({1, 1}));
    CHECK(primitive_gcd(of({2, -4}), IntegerPolynomial()) == of({-1, 2}));
    CHECK(primitive_gcd(IntegerPolynomial(), of({2, -4})) == of({-1, 2}));
    CHECK_THROWS_AS(primitive_gcd(IntegerPolynomial(), IntegerPolynomial()), std::domain_error);
}
