// SPDX-License-Identifier: GPL-2.0-or-later
/// Factors for people to read: known answers.
#include <doctest/doctest.h>

#include <stdexcept>

#include "generator/exact/factors.hpp"
#include "generator/exact/rational_function.hpp"
#include "tests/support/known_roots.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

Polynomial product(const Factors& factors) {
    Polynomial result = constant(factors.content);
    for (const Factor& factor : factors.factors) {
        for (unsigned i = 0; i < factor.power; ++i) {
            result *= over_rationals(factor.polynomial);
        }
    }
    return result;
}

}  // namespace

TEST_CASE("linear factors, real quadratic ones and the rest, in order") {
    // -3/7 x (x+1)^3 (2x+1) (3x^2+3x-1)^2 (x^2+1) (x^3-2)
    const Polynomial once = poly({0, 1}) * poly({1, 1}) * poly({1, 1}) * poly({1, 1}) *
                            poly({1, 2}) * poly({-1, 3, 3}) * poly({-1, 3, 3});
    const Polynomial rest = poly({1, 0, 1}) * poly({-2, 0, 0, 1});
    const Polynomial whole = once * rest * constant(Rational(-3, 7));
    const Factors found = factors_of(whole);
    CHECK(found.content == Rational(-3, 7));
    REQUIRE(found.factors.size() == 5);
    const Polynomial expected[]{poly({0, 1}), poly({1, 1}), poly({1, 2}), poly({-1, 3, 3}), rest};
    const unsigned powers[]{1, 3, 1, 2, 1};
    for (std::size_t i = 0; i < 5; ++i) {
        CAPTURE(i);
        CHECK(over_rationals(found.factors[i].polynomial) == expected[i]);
        CHECK(found.factors[i].power == powers[i]);
    }
    CHECK(product(found) == whole);
}

TEST_CASE("negative roots far out, constants, zero") {
    CHECK(factors_of(poly({1000000, 1}) * poly({1, 1000000})).factors.size() == 2);
    CHECK(factors_of(constant(Rational(-2, 3))).content == Rational(-2, 3));
    CHECK(factors_of(constant(5)).factors.empty());
    CHECK_THROWS_AS(factors_of(Polynomial()), std::domain_error);
}
