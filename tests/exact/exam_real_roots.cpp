// SPDX-License-Identifier: GPL-2.0-or-later
/// Real roots: known answers.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "tests/support/known_roots.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

TEST_CASE("factors are found in products, with multiple roots and among others") {
    // (x^2 - 4x + 2)^2 (3x - 1)^3 x (x^2 + 1) (x^3 - 2)
    const Polynomial quadratic = poly({2, -4, 1});
    const Polynomial cubic = poly({-2, 0, 0, 1});
    const Polynomial third = poly({-1, 3});
    const Polynomial f =
        quadratic * quadratic * third * third * third * poly({0, 1}) * poly({1, 0, 1}) * cubic;
    const auto roots = real_roots(f, everywhere);
    CHECK(texts(roots) == Texts{"0", "1/3", "2 - sqrt(2)", "", "2 + sqrt(2)"});
    CHECK(all_well_formed(roots));
    CHECK(over_rationals(roots[2].polynomial) == quadratic);
    CHECK(equal(roots[3], real_roots(cubic, 0).at(0)));
    CHECK(nearest_double(roots[3]) == 0x1.428a2f98d728bp+0);
    CHECK(square_free(f).degree() == 9U);

    // Irrational roots only in pairs that do not make a rational quadratic: sqrt(2) +- sqrt(3).
    CHECK(texts(real_roots(poly({1, 0, -10, 0, 1}), everywhere)) == Texts{"", "", "", ""});
    // A quadratic whose other root is below the limit.
    CHECK(texts(real_roots(quadratic * cubic, 2)) == Texts{"2 + sqrt(2)"});
}

TEST_CASE("a root 1e-30 from a quadratic number is not taken for it") {
    const Polynomial quadratic = poly({-2, 0, 1});
    const Polynomial near =
        poly({0, 0, 0, 0, 0, 0, 0, 1}) + quadratic * constant(Rational(pow(Integer(10), 30)));
    CHECK(texts(real_roots(near, everywhere)) == Texts{"", "", ""});
    CHECK(texts(real_roots(near * quadratic, everywhere)) ==
          Texts{"", "", "-sqrt(2)", "", "sqrt(2)"});
}

TEST_CASE("Sturm's chain may leave out degrees") {
    CHECK(count_real_roots(poly({1, 4, 0, 0, 1}), std::nullopt, std::nullopt) == 2);  // 4, 3, 1, 0
    CHECK(count_real_roots(poly({1, -4, 0, 0, 1}), std::nullopt, std::nullopt) == 2);
}

TEST_CASE("roots at the ends of the interval") {
    const Polynomial f = linear(1) * linear(Rational(5, 3)) * linear(4) * poly({2, -4, 1});
    CHECK(texts(real_roots(f, 1, 4)) == Texts{"1", "5/3", "2 + sqrt(2)", "4"});
    CHECK(texts(real_roots(f, Rational(5, 3))) == Texts{"5/3", "2 + sqrt(2)", "4"});
    CHECK(texts(real_roots(f, 4, 4)) == Texts{"4"});
    CHECK(real_roots(f, 4, 1).empty());
    CHECK(real_roots(f, 5).empty());
    CHECK(real_roots(constant(-7), 0).empty());
    CHECK(count_real_roots(f, 1, 4) == 4);
    CHECK(count_real_roots(f, 1, 4, Ends::open) == 2);
    CHECK(count_real_roots(f, 4, 4) == 1);
    CHECK(count_real_roots(f, 4, 4, Ends::open) == 0);
    CHECK(count_real_roots(f, 4, 1) == 0);
    CHECK(count_real_roots(f, std::nullopt, 1) == 2);
    CHECK(count_real_roots(f, std::nullopt, 1, Ends::open) == 1);
    CHECK(count_real_roots(f, 4, std::nullopt, Ends::open) == 0);
    CHECK(count_real_roots(f, std::nullopt, std::nullopt, Ends::open) == 5);
    CHECK(count_real_roots(f, std::nullopt, -1000000) == 0);
    CHECK(count_real_roots(f, 1000000, std::nullopt) == 0);
    // Intervals keep to the limits.
    const auto near = real_roots(poly({2, -4, 1}), Rational(58, 100), Rational(59, 100));
    CHECK(near.at(0).low >= Rational(58, 100));
    CHECK(near.at(0).high <= Rational(59, 100));
    CHECK_THROWS_AS(real_roots(Polynomial(), 0), std::domain_error);
    CHECK_THROWS_AS(count_real_roots(Polynomial(), 0, 1), std::domain_error);
    CHECK_THROWS_AS(square_free(Polynomial()), std::domain_error);
}

TEST_CASE("roots 1e-12 apart") {
    const Rational gap(1, pow(Integer(10), 12));
    const Rational third(1, 3);
    CHECK(texts(real_roots(linear(third) * linear(third + gap), 0)) ==
          Texts{"1/3", "1000000000003/3000000000000"});
    // x^3 - 2 and the same moved by the gap: neither rational nor quadratic.
    const Polynomial moved = poly({-gap, 1}) * poly({-gap, 1}) * poly({-gap, 1}) - constant(2);
    const auto roots = real_roots(poly({-2, 0, 0, 1}) * moved, everywhere);
    REQUIRE(roots.size() == 2);
    CHECK(all_well_formed(roots));
    CHECK(std::is_lt(compare(roots[0], roots[1])));
    CHECK(nearest_double(roots[1]) - nearest_double(roots[0]) ==
          doctest::Approx(1e-12).epsilon(1e-3).scale(0));
    const Rational between = rational_between(roots[0], roots[1]);
    CHECK(std::is_lt(compare(roots[0], between)));
    CHECK(std::is_gt(compare(roots[1], between)));
}

TEST_CASE("Wilkinson's polynomial of degree 15, and disturbed") {
    Polynomial f = constant(1);
    Texts expected;
    for (int k = 1; k <= 15; ++k) {
        f *= linear(k);
        expected.push_back(std::to_string(k));
    }
    CHECK(texts(real_roots(f, 0)) == expected);
    // Minus x^14/2^23, two pairs of roots have turned complex (mpmath, 60 digits).
    std::vector<Rational> x14(15, Rational(0));
    x14.back() = Rational(1, 1 << 23);
    const auto roots = real_roots(f - Polynomial(std::move(x14)), everywhere);
    CHECK(all_well_formed(roots));
    REQUIRE(roots.size() == 11);
    CHECK(nearest_double(roots[8]) == doctest::Approx(9.1101512));
    CHECK(nearest_double(roots[9]) == doctest::Approx(9.7574589));
    CHECK(nearest_double(roots[10]) == doctest::Approx(15.0367));
}

TEST_CASE("roots of the Chebyshev polynomial T_9 are cosines") {
    Polynomial last = constant(1);
    Polynomial chebyshev = poly({0, 1});
    for (int k = 1; k < 9; ++k) {
        last = poly({0, 2}) * chebyshev - last;
        std::swap(last, chebyshev);
    }
    const auto roots = real_roots(chebyshev, -1, 1);
    CHECK(texts(roots) == Texts{"", "-sqrt(3)/2", "", "", "0", "", "", "sqrt(3)/2", ""});
    CHECK(all_well_formed(roots));
    for (std::size_t k = 0; k < roots.size(); ++k) {
        const double angle = (17 - 2 * double(k)) * std::numbers::pi / 18;
        CHECK(std::abs(nearest_double(roots[k]) - std::cos(angle)) < 2.3e-16);
        CHECK(rounded_correctly(roots[k]));
        CHECK(sign_at(chebyshev, roots[k]) == 0);
        CHECK(sign_at(chebyshev.prime(), roots[k]) == (k % 2 == 0 ? 1 : -1));
    }
}
