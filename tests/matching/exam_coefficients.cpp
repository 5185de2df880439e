// SPDX-License-Identifier: GPL-2.0-or-later
/// Coefficients known from the paper or by hand, and the paper's own example (52), (53).
#include <doctest/doctest.h>
#include <ginac/ginac.h>

#include <stdexcept>

#include "generator/exact/rational_function.hpp"
#include "generator/matching/matching.hpp"
#include "generator/pipeline.hpp"
#include "tests/support/literal_system.hpp"
#include "tests/support/taylor.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

Table nopd1d_table(unsigned horizon, unsigned order, std::optional<Rational> G = {},
                   unsigned stride = 1) {
    return derive({.family = "nopd1d",
                   .horizon = horizon,
                   .order = order,
                   .stride = stride,
                   .stabilisation = std::move(G)});
}

/// numerator/denominator from coefficients in ascending powers of G.
ExactFunction function(std::vector<Rational> numerator, std::vector<Rational> denominator) {
    return reduce(Polynomial(std::move(numerator)), Polynomial(std::move(denominator)));
}

ExactFunction number(const Rational& value) {
    return to_rational_function(constant(value));
}

}  // namespace

TEST_CASE("NMBC1 is c = (1, 1), b = (-2, 2)/s for every model: (58) and Table 1, row 1") {
    for (const unsigned n : {1U, 2U, 3U, 4U, 5U}) {
        for (const unsigned stride : {1U, 2U, 3U}) {
            const Table table = nopd1d_table(n, 1, {}, stride);
            CHECK(table.c == std::vector{number(1), number(1)});
            CHECK(table.b ==
                  std::vector{number(Rational(-2, int(stride))), number(Rational(2, int(stride)))});
        }
    }
}

TEST_CASE("MBC2 at n = 2, G = 0: c_1 = -9/2, b_0 = 5/4 (text after (53))") {
    const Table table = nopd1d_table(2, 2, Rational(0));
    CHECK(table.c == std::vector{number(1), number(Rational(-9, 2)), number(1)});
    CHECK(table.b == std::vector{number(Rational(5, 4)), number(0), number(Rational(-5, 4))});
    // Table 1 says the same: a_3 = 17/30 at n = 2, so I_1 = 4(1 + 17/10)/(1 - 17/5) = -9/2.
    CHECK(4 * (1 + Rational(17, 10)) / (1 - Rational(17, 5)) == Rational(-9, 2));
}

TEST_CASE("n = 2, N = 2: functions of G with the pole G = 128/85") {
    // a_3 = (544 - 255 G)/960; I_1 = 4(1 + 3 a_3)/(1 - 6 a_3), I_2 = -3/(1 - 6 a_3), where
    // 1 + 3 a_3 = (864 - 255 G)/320 and 1 - 6 a_3 = (-384 + 255 G)/160.
    const Table table = nopd1d_table(2, 2);
    CHECK(table.c[1] == function({576, -170}, {-128, 85}));  // -2(85 G - 288)/(85 G - 128)
    CHECK(table.b[0] == function({-160}, {-128, 85}));
    CHECK(table.b[1] == number(0));
}

TEST_CASE("n = 1, N = 3: functions of G") {
    // I_3 = 3(3 + 40(a_3 + a_5))/(1 - 120 a_5), a_3 = 1/6 - G/4, a_5 = 1/120 - G^2/32:
    // 1 - 120 a_5 = 15 G^2/4 and 3 + 40(a_3 + a_5) = 10 - 10 G - 5 G^2/4.
    // I_4 = (720(a_3^2 - a_5) + 120 a_3 + 11)/(3(120 a_5 - 1)), its numerator
    //       20 - 60 G + 45 G^2 - 6 + 45 G^2/2 + 20 - 30 G + 11 = 45 - 90 G + 135 G^2/2.
    const Table table = nopd1d_table(1, 3);
    CHECK(table.c[1] == function({8, -8, -1}, {0, 0, 1}));
    CHECK(table.b[0] == function({-4, 8, -6}, {0, 0, 1}));  // -2(3G^2 - 4G + 2)/G^2
    CHECK(table.b[0] == function({45, -90, Rational(135, 2)}, {0, 0, Rational(-45, 4)}));
}

TEST_CASE("(52) and (53): the system for N = 1 as printed") {
    const GiNaC::symbol a1("a_1");
    const GiNaC::symbol dX("dX");
    const std::vector<GiNaC::ex> taylor{0, a1, 0};
    using Rows = Matrix<GiNaC::ex>;
    const auto same = [](const Rows& found, const Rows& printed) {
        REQUIRE(found.size() == printed.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            REQUIRE(found[i].size() == printed[i].size());
            for (std::size_t j = 0; j < found[i].size(); ++j) {
                CHECK((found[i][j] - printed[i][j]).expand().is_zero());
            }
        }
    };
    const GiNaC::ex half_square = dX * dX / 2;
    same(taylor_matrix(taylor, 1), {{0, 0, 0}, {a1, 0, 0}, {0, a1, 0}});
    same(offset_matrix<GiNaC::ex>(dX, 1), {{1, 1}, {0, dX}, {0, half_square}});
    same(literal_matrix<GiNaC::ex>(taylor, dX, 1),
         {{1, 0, 0, 0}, {0, 0, -1, -1}, {a1, a1, 0, -dX}, {0, a1 * dX, 0, -half_square}});
}

TEST_CASE("the solution of (53) is c_1 = 1, b_0 = -2 a_1/dX, b_1 = 2 a_1/dX") {
    const Rational a1(7, 3);
    const Rational dX(5, 4);
    const auto solution = solve_literally({0, a1, 0}, dX, 1);
    REQUIRE(solution);
    CHECK(*solution == std::vector<Rational>{1, 1, -2 * a1 / dX, 2 * a1 / dX});
}

TEST_CASE("undamped, the committed set is symmetric: c_j = c_{N-j}, b_j = -b_{N-j}") {
    for (const Specification& specification : committed_set()) {
        if (specification.damping != 0) {
            continue;
        }
        const Table table = derive(specification);
        const std::size_t N = specification.order;
        CAPTURE(specification.horizon);
        CAPTURE(N);
        REQUIRE(table.c.size() == N + 1);
        REQUIRE(table.b.size() == N + 1);
        for (std::size_t j = 0; j <= N; ++j) {
            CHECK(table.c[j] == table.c[N - j]);
            CHECK(table.b[j].denominator == table.b[N - j].denominator);
            CHECK((table.b[j].numerator + table.b[N - j].numerator).is_zero());
        }
    }
}

TEST_CASE("match refuses what it cannot use") {
    CHECK_THROWS_AS(match({0, 1, 0}, 1, 0), std::invalid_argument);
    CHECK_THROWS_AS(match({0, 1}, 1, 1), std::invalid_argument);        // needs a_0 .. a_2
    CHECK_THROWS_AS(match({0, 1, 0, 1}, 1, 2), std::invalid_argument);  // needs a_0 .. a_4
    CHECK_THROWS_AS(match({1, 1, 0}, 1, 1), std::invalid_argument);     // a_0 is not zero
    Specification unknown;
    unknown.family = "nopd9d";
    CHECK_THROWS_AS(derive(unknown), std::invalid_argument);
}
