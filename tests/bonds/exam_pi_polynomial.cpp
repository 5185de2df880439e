// SPDX-License-Identifier: GPL-2.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "generator/bonds/pi_polynomial.hpp"

using namespace nmbcgen;

TEST_CASE("arithmetic of quadratic numbers") {
    const Quadratic one_plus_root(1, 1, 2);
    CHECK(one_plus_root * one_plus_root == Quadratic(3, 2, 2));
    Quadratic quotient = 1;
    quotient /= one_plus_root;
    CHECK(quotient == Quadratic(-1, 1, 2));
    quotient -= Quadratic(0, 1, 2);
    CHECK(quotient == Quadratic(-1));
    CHECK(square_root(1) == Quadratic(1));
    CHECK(square_root(49) == Quadratic(7));
    CHECK(square_root(72) == Quadratic(0, 6, 2));
}

TEST_CASE("numbers of two fields do not meet, and 0 divides nothing") {
    Quadratic number(0, 1, 2);
    CHECK_THROWS_AS(number += Quadratic(0, 1, 3), std::logic_error);
    CHECK_THROWS_AS(number /= Quadratic(0), std::domain_error);
    CHECK_THROWS_AS(Quadratic(0, 1, 12), std::invalid_argument);
    CHECK_THROWS_AS(Quadratic(0, 1, 1), std::invalid_argument);
}

TEST_CASE("values and texts of polynomials in pi") {
    const PiPolynomial number{Quadratic(Rational(-1, 2)), Quadratic(0, Rational(3), 2),
                              Quadratic(1)};
    constexpr double pi = std::numbers::pi;
    // One rounding of each.
    CHECK(double(value_of(number)) ==
          doctest::Approx(-0.5 + 3 * std::numbers::sqrt2 * pi + pi * pi).epsilon(1e-15));
    CHECK(to_text(number) == "-1/2 + 3*sqrt(2)*pi + pi^2");
    CHECK(to_text({Quadratic(Rational(1, 3), Rational(-1), 5)}) == "1/3 - sqrt(5)");
    CHECK(to_text({Quadratic(0), Quadratic(0)}) == "0");
    CHECK(to_text(PiPolynomial{}) == "0");
}
