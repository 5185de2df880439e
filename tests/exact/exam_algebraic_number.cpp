// SPDX-License-Identifier: GPL-2.0-or-later
/// Algebraic numbers: text and rounding with known answers.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/support/known_roots.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

TEST_CASE("quadratic numbers as radicals") {
    CHECK(texts(real_roots(poly({2, -4, 1}), 0)) == Texts{"2 - sqrt(2)", "2 + sqrt(2)"});
    // Sum 2*5584/4335, product (5584^2 - 80^2 433)/4335^2 = 32768/21675.
    CHECK(texts(real_roots(poly({Rational(32768, 21675), Rational(-11168, 4335), 1}), 0)) ==
          Texts{"(5584 - 80*sqrt(433))/4335", "(5584 + 80*sqrt(433))/4335"});
    CHECK(texts(real_roots(poly({-9, 0, 2}), -9)) == Texts{"-3*sqrt(2)/2", "3*sqrt(2)/2"});
    CHECK(texts(real_roots(poly({-1, -1, 1}), -9)) == Texts{"(1 - sqrt(5))/2", "(1 + sqrt(5))/2"});
    CHECK(texts(real_roots(poly({-3, 0, 1}), 0)) == Texts{"sqrt(3)"});
    CHECK(texts(real_roots(poly({-3, 0, 1}), -2, 0)) == Texts{"-sqrt(3)"});
    CHECK(texts(real_roots(poly({-3, 0, 9}), 0)) == Texts{"sqrt(3)/3"});
    // Radicands with square factors: 4*49*11, and the square of a prime above 10^6 times 2.
    CHECK(texts(real_roots(poly({-2156, 0, 1}), 0)) == Texts{"14*sqrt(11)"});
    const Integer prime = 1000003;
    CHECK(texts(real_roots(poly({Rational(-2 * prime * prime), 0, 1}), 0)) ==
          Texts{"1000003*sqrt(2)"});
    CHECK(texts(real_roots(poly({-2, 0, 0, 1}), 0)) == Texts{""});  // a cube root has no text
}

TEST_CASE("rounding next to half-way, and of very large and very small numbers") {
    const auto power = [](int exponent) {
        const Rational value(Integer(1) << unsigned(std::abs(exponent)));
        return exponent < 0 ? Rational(1 / value) : value;
    };
    // Cube roots of m^3 -+ 2^-300, m = 1 + 2^-53 half-way between two doubles.
    const Rational m = 1 + power(-53);
    for (const int side : {-1, 1}) {
        const KnownRoot next_to_m{0, 3, m * m * m + side * power(-300)};
        const auto numbers = real_roots(next_to_m.factor(), 0);
        CHECK(nearest_double(numbers.at(0)) == (side < 0 ? 1 : 1 + 0x1p-52));
    }
    for (const int exponent : {1023, -1022, -1040, -1070}) {  // the last two subnormal
        const auto large = real_roots(KnownRoot{0, 2, 2 * power(2 * exponent)}.factor(), 0);
        CHECK(nearest_double(large.at(0)) == std::ldexp(std::numbers::sqrt2, exponent));
    }
    const auto huge = real_roots(KnownRoot{0, 2, 2 * power(2048)}.factor(), 0);
    CHECK_THROWS_AS(nearest_double(huge.at(0)), std::overflow_error);
    CHECK(nearest_double(to_algebraic_number(m)) == 1);  // a tie, to even
}
