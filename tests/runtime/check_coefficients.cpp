// SPDX-License-Identifier: GPL-2.0-or-later
/// Coefficients at a given G, against exact rationals.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <nmbc/lattice.hpp>
#include <nmbc/tables/tables.hpp>
#include <random>
#include <sstream>

#include "generator/exact/rational.hpp"

namespace {

using nmbcgen::Rational;

/// The polynomial of a table's string at an exact G.
Rational exactly(std::string_view coefficients, const Rational& G) {
    std::istringstream stream{std::string(coefficients)};
    Rational sum = 0;
    Rational power = 1;
    for (std::string integer; stream >> integer; power *= G) {
        sum += Rational(integer) * power;
    }
    return sum;
}

/// Runs a check on every function of every committed table.
template <class Check>
void for_all_functions(Check check) {
    for (const auto* table : nmbc::generated::tables) {
        for (const auto list : {table->lattice->symbol, table->taylor, table->c, table->b}) {
            for (const auto& function : list) {
                check(function);
            }
        }
    }
}

/// Checks the value at G, or the exception where G is a pole. Evaluation is exact up to one
/// rounding, so not one unit in the last place is allowed (4 would do for users).
void check_at(const nmbc::RationalFunction& function, double G) {
    CAPTURE(function.numerator);
    CAPTURE(function.denominator);
    CAPTURE(G);
    const Rational exact_G(G);
    const Rational bottom = exactly(function.denominator, exact_G);
    if (bottom == 0) {
        CHECK_THROWS_AS(nmbc::evaluate(function, G), nmbc::CoefficientError);
        return;
    }
    const Rational value = exactly(function.numerator, exact_G) / bottom;
    if (abs(value) > Rational(std::numeric_limits<double>::max())) {
        CHECK_THROWS_AS(nmbc::evaluate(function, G), nmbc::CoefficientError);
        return;
    }
    CHECK(nmbc::evaluate(function, G) == nmbcgen::nearest_double(value));
}

TEST_CASE("coefficients are correctly rounded at random and at simple G") {
    std::mt19937_64 random(20180417);
    std::uniform_real_distribution<double> exponent(-40, 10);
    std::vector<double> values{0, 0.25, 0.5, 1, 1.5, 2, 3, 0.1, 1e-300, 1e10};
    for (int i = 0; i < 20; ++i) {
        values.push_back(std::exp2(exponent(random)));
    }
    for_all_functions([&values](const nmbc::RationalFunction& function) {
        for (const double G : values) {
            check_at(function, G);
        }
    });
}

TEST_CASE("coefficients are correctly rounded within a few units of every pole") {
    // Bracket each sign change of the denominator on a grid, bisect to neighbouring doubles, and
    // evaluate there and a few doubles around: up to 53 bits cancel in the denominator.
    int poles = 0;
    for_all_functions([&poles](const nmbc::RationalFunction& function) {
        const auto negative = [&function](double G) {
            return exactly(function.denominator, Rational(G)) < 0;
        };
        for (double G = 0; G < 6; G += 1.0 / 16) {
            double low = G;
            double high = G + 1.0 / 16;
            if (negative(low) == negative(high)) {
                continue;
            }
            while (std::nextafter(low, high) < high) {
                const double middle = low + (high - low) / 2;
                (negative(middle) == negative(low) ? low : high) = middle;
            }
            ++poles;
            double near = low;
            for (int i = 0; i < 4; ++i) {
                check_at(function, near);
                near = std::nextafter(near, 0.0);
            }
            near = high;
            for (int i = 0; i < 4; ++i) {
                check_at(function, near);
                near = std::nextafter(near, 10.0);
            }
        }
    });
    CHECK(poles > 40);  // 5 tables with poles at least, c and b lists each
}

TEST_CASE("a pole, a degenerate G and a bad G are refused by name") {
    const auto* table = nmbc::find_table(nmbc::generated::tables, "nopd1d", 1, 3);
    REQUIRE(table != nullptr);
    CHECK_THROWS_WITH_AS(nmbc::boundary_coefficients(*table, 0),
                         doctest::Contains("pole of a coefficient at G = 0"),
                         nmbc::CoefficientError);
    CHECK_THROWS_WITH_AS(nmbc::boundary_coefficients(*table, 1), doctest::Contains("C(1) = 0"),
                         nmbc::CoefficientError);
    for (const double G : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        CHECK_THROWS_AS(nmbc::boundary_coefficients(*table, G), std::invalid_argument);
    }
    // The nearest doubles of 208/85 and 405/98 are not these numbers, but as good as.
    for (const auto& degenerate : {std::pair{2, 208.0 / 85}, std::pair{3, 405.0 / 98}}) {
        const int horizon = degenerate.first;
        const double G = degenerate.second;
        CAPTURE(horizon);
        const auto* third = nmbc::find_table(nmbc::generated::tables, "nopd1d", horizon, 3);
        REQUIRE(third != nullptr);
        CHECK_THROWS_AS(nmbc::boundary_coefficients(*third, G), nmbc::CoefficientError);
        CHECK_NOTHROW(nmbc::boundary_coefficients(*third, G * (1 + 1e-9), nmbc::allow_unstable));
    }
}

TEST_CASE("every double next to a zero of C(1) is refused") {
    for (const auto* table : nmbc::generated::tables) {
        const auto negative = [table](double G) {  // the sign of C(1), exactly
            Rational sum = 0;
            for (const auto& c : table->c) {
                sum += exactly(c.numerator, G) / exactly(c.denominator, G);
            }
            return sum < 0;
        };
        for (double G = 1.0 / 32; G < 6; G += 1.0 / 16) {  // no pole lies on this grid
            double low = G;
            double high = G + 1.0 / 16;
            if (negative(low) == negative(high)) {
                continue;
            }
            while (std::nextafter(low, high) < high) {
                const double middle = low + (high - low) / 2;
                (negative(middle) == negative(low) ? low : high) = middle;
            }
            // A pole, where C(1) jumps from one infinity to the other, is not refused beside it.
            const auto size = [table](double at) {
                return std::abs(nmbc::evaluate(table->c[1], at));
            };
            if (size(low) > 1e10) {
                continue;
            }
            CAPTURE(table->name);
            CHECK_THROWS_AS(nmbc::boundary_coefficients(*table, low), nmbc::CoefficientError);
            CHECK_THROWS_AS(nmbc::boundary_coefficients(*table, high), nmbc::CoefficientError);
        }
    }
}

TEST_CASE("a table made for one G is for no other") {
    nmbc::MatchingTable table = *nmbc::find_table(nmbc::generated::tables, "nopd1d", 1, 1);
    table.fixed_G = "1/4";
    CHECK_NOTHROW(nmbc::boundary_coefficients(table, 0.25, nmbc::allow_unstable));
    CHECK_THROWS_AS(nmbc::boundary_coefficients(table, 7), std::invalid_argument);
    CHECK_THROWS_AS(nmbc::make_lattice(table, 7), std::invalid_argument);
    table.fixed_G = "3";
    CHECK_NOTHROW(nmbc::make_lattice(table, 3));
}

TEST_CASE("known coefficients") {
    // theory: n = 2, N = 2, G = 0: c_1 = -9/2, b_0 = 5/4 (also printed in Nicely 2018, section 4)
    const auto* second = nmbc::find_table(nmbc::generated::tables, "nopd1d", 2, 2);
    REQUIRE(second != nullptr);
    const auto at_0 = nmbc::boundary_coefficients(*second, 0, nmbc::allow_unstable);
    CHECK(at_0.c == std::vector<double>{1, -4.5, 1});
    CHECK(at_0.b == std::vector<double>{1.25, 0, -1.25});
    // n = 1, N = 3 at G = 1/2: c_1 = -(1/4 + 4 - 8)/(1/4) = 15, b_0 = -2(3/4 - 2 + 2)/(1/4) = -6
    const auto* third = nmbc::find_table(nmbc::generated::tables, "nopd1d", 1, 3);
    REQUIRE(third != nullptr);
    const auto at_half = nmbc::boundary_coefficients(*third, 0.5, nmbc::allow_unstable);
    CHECK(at_half.c == std::vector<double>{1, 15, 15, 1});
    CHECK(at_half.b[0] == -6);
}

TEST_CASE("the registry finds every committed table and no other") {
    for (const auto* table : nmbc::generated::tables) {
        CHECK(nmbc::find_table(nmbc::generated::tables, table->lattice->family,
                               table->lattice->horizon, table->order, table->stride,
                               table->lattice->tau, table->time_step) == table);
        CHECK(table->ghost_layers() ==
              (table->lattice->family == "chain1d" ? 1 : 2 * std::size_t(table->lattice->horizon)));
    }
    CHECK(nmbc::find_table(nmbc::generated::tables, "nopd1d", 1, 99) == nullptr);
    CHECK(nmbc::find_table(nmbc::generated::tables, "chain", 1, 1) == nullptr);
    CHECK(nmbc::find_table(nmbc::generated::tables, "nopd1d", 1, 1, 7) == nullptr);
}

}  // namespace
