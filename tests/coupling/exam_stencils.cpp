// SPDX-License-Identifier: MIT
/// Exact stencils of uniform nonlocal bars, and the numbers they are made of.
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include "generator/coupling/assembly.hpp"
#include "generator/exact/rational.hpp"

using namespace nmbcgen;

TEST_CASE("logarithms have one form") {
    CHECK(to_string(log_of(Rational(12, 7))) == "(2) ln(2) + (1) ln(3) + (-1) ln(7)");
    LogNumber sum = log_of(Rational(9, 4));
    sum += Rational(2) * log_of(Rational(2, 3));
    CHECK(sum == LogNumber{});
    CHECK(to_string(sum) == "0");
    CHECK(Rational(0) * log_of(5) == LogNumber{});
    CHECK(log_of(1) == LogNumber{});
    CHECK(to_string(log_of(999983)) == "(1) ln(999983)");
    CHECK_THROWS_AS(log_of(0), std::invalid_argument);
    CHECK_THROWS_AS(log_of(1000003), std::invalid_argument);
    CHECK_THROWS_AS(log_of(Rational(Integer("1000003") * 1000033)), std::invalid_argument);
    // What cancels: 1e40 (ln 2 - its first 40 digits).
    const LogNumber rest{Rational(Integer("-6931471805599453094172321214581765680755")),
                         {{2, Rational(Integer("10000000000000000000000000000000000000000"))}}};
    CHECK(nearest_double(rest) == doctest::Approx(0.00134360255254120680).epsilon(1e-15));
}

TEST_CASE("horizons up to an element have rational stencils") {
    for (const Rational& r : {Rational(1, 1000), Rational(1, 4), Rational(2, 3), Rational(1)}) {
        CAPTURE(to_string(r));
        CHECK(uniform_stencil(r) ==
              std::vector<LogNumber>{{2 - 2 * r / 3}, {-(1 - 4 * r / 9)}, {-r / 9}});
    }
    CHECK(uniform_stencil(0) == std::vector<LogNumber>{{2}, {-1}});
}

TEST_CASE("longer ones have logarithms") {
    const std::vector<LogNumber> two = uniform_stencil(2);
    CHECK(two.size() == 4);
    CHECK(two[0] == LogNumber{Rational(11, 9), {{2, -Rational(2, 3)}}});
    LogNumber expected{Rational(121, 81)};
    expected += Rational(32, 27) * log_of(Rational(2, 3));
    CHECK(uniform_stencil(Rational(3, 2))[0] == expected);
}

TEST_CASE("what every uniform stencil keeps, exactly") {
    for (const Rational& r : {Rational(1, 3), Rational(7, 5), Rational(2), Rational(7, 2),
                              Rational(6), Rational(123, 10)}) {
        CAPTURE(to_string(r));
        const std::vector<LogNumber> stencil = uniform_stencil(r);
        CHECK(Rational(stencil.size()) == 2 - floor(-r));
        LogNumber sum = stencil[0];
        LogNumber moment;
        for (std::size_t m = 1; m < stencil.size(); ++m) {
            sum += Rational(2) * stencil[m];
            moment += Rational(m * m) * stencil[m];
        }
        CHECK(sum == LogNumber{});
        CHECK(moment == LogNumber{-1});  // the local bar's modulus
    }
}

TEST_CASE("both forms are the same where nothing changes") {
    const Medium medium{Rational(5, 3), Rational(7, 5)};
    const Mesh mesh = mesh_of({1, 1, medium, medium}, 5, 5);
    CHECK(exact_rows(mesh, CouplingForm::pairs, 5, 5) ==
          exact_rows(mesh, CouplingForm::rows, 5, 5));
}

TEST_CASE("the longest horizon has a stencil of doubles that fall to 0, and there is none beyond") {
    const std::vector<LogNumber> stencil = uniform_stencil(largest_coupling_horizon);
    CHECK(stencil.size() == largest_coupling_horizon + 2);
    // omega^2 = (4/delta^2) Cin(k delta) of the continuum, at k delta = 1: elements are short.
    double squared = 0;
    for (std::size_t m = 1; m < stencil.size(); ++m) {
        squared -= 4 * nearest_double(stencil[m]) *
                   std::pow(std::sin(double(m) / (2.0 * largest_coupling_horizon)), 2);
    }
    constexpr double cosine_integral = 0.23981174200056472594;
    const double delta = largest_coupling_horizon;
    CHECK(squared == doctest::Approx(4 / (delta * delta) * cosine_integral).epsilon(1e-4));
    CHECK_THROWS_AS(uniform_stencil(largest_coupling_horizon + 1), std::invalid_argument);
    CHECK_THROWS_AS(uniform_stencil(-1), std::invalid_argument);
}
