// SPDX-License-Identifier: GPL-2.0-or-later
/// Table 1 of Nicely 2018 with I_1 .. I_9 of its appendix A, as identities in a_1, a_3, a_5, a_7
/// and dX: what is printed there, character by character, and what match() derives.
#include <doctest/doctest.h>
#include <ginac/ginac.h>

#include <random>

#include "generator/matching/matching.hpp"
#include "tests/support/literal_system.hpp"
#include "tests/support/printed.hpp"

using GiNaC::ex;
using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

const GiNaC::symbol a1("a_1");
const GiNaC::symbol a3("a_3");
const GiNaC::symbol a5("a_5");
const GiNaC::symbol a7("a_7");
const GiNaC::symbol dX_of_table("dX");

/// The denominators that several printed formulas share.
const std::string denominator_6 =
    "(25200*(a5^2-a3*a7) + 4200*(-a3*a5+a1*a7)*dX^2 + 35*(3*a3^2+8*a1*a5)*dX^4 + 5*a1*a3*dX^6"
    " - 2*a1^2*dX^8)";

const std::string I1 = "4*(a1*dX^2+3*a3) / (a1*dX^2-6*a3)";
const std::string I2 = "-3*a1^2*dX / (a1*dX^2-6*a3)";
const std::string I3 = "3*(3*a1*dX^4 + 40*(a3*dX^2+a5)) / (a1*dX^4-120*a5)";
const std::string I4 = "(720*(a3^2-a1*a5) + 120*a1*a3*dX^2 + 11*a1^2*dX^4) / (360*a5*dX-3*a1*dX^5)";
const std::string I5 =
    "3*(-240*a3^2 + 240*a1*a5 + 40*a1*a3*dX^2 + 3*a1^2*dX^4) / (dX*(120*a5-a1*dX^4))";
const std::string I6 =
    "8*(12600*(-a5^2+a3*a7) + 1050*(-a3*a5+a1*a7)*dX^2 + 35*(21*a3^2-19*a1*a5)*dX^4"
    " - 55*a1*a3*dX^6 - 4*a1^2*dX^8) / " +
    denominator_6;
const std::string I7 =
    "6*(25200*(a5^2-a3*a7) + 4200*(a3*a5-a1*a7)*dX^2 + 315*(7*a3^2-8*a1*a5)*dX^4"
    " - 205*a1*a3*dX^6 - 12*a1^2*dX^8) / " +
    denominator_6;
const std::string I8 =
    "5*dX*(-7560*(a3^3-2*a1*a3*a5+a1^2*a7) + 63*a1^2*a3*dX^4 + 5*a1^3*dX^6) / (3*" + denominator_6 +
    ")";
const std::string I9_before_last_term =
    "40*dX*(1890*(a3^3-2*a1*a3*a5+a1^2*a7) + 945*a1*(-a3^2+a1*a5)*dX^2 + 63*a1^2*a3*dX^4";
const std::string I9_printed = I9_before_last_term + " + 4*a1^2*dX^6) / (3*" + denominator_6 + ")";
const std::string I9_corrected =
    I9_before_last_term + " + 4*a1^3*dX^6) / (3*" + denominator_6 + ")";

ex printed_ratio(const std::string& formula) {
    return Reader({{"a1", a1}, {"a3", a3}, {"a5", a5}, {"a7", a7}, {"dX", dX_of_table}})(formula);
}

/// c_j and b_j of NMBC1 to 4, nothing known of the model but a_0 = a_2 = .. = 0.
MatchingPolynomials general(unsigned order) {
    return match({0, a1, 0, a3, 0, a5, 0, a7, 0}, dX_of_table, order);
}

/// Whether C[j]/C[0], or B[j]/C[0], is the printed formula, identically.
bool holds(const std::vector<ex>& coefficients, unsigned j, const std::string& formula,
           const ex& C0) {
    return identical(coefficients[j] / C0, printed_ratio(formula));
}

/// One row of Table 1.
void check_row(const std::vector<std::string>& c, const std::vector<std::string>& b) {
    const unsigned order = unsigned(c.size()) - 1;
    CAPTURE(order);
    const MatchingPolynomials found = general(order);
    REQUIRE_FALSE(found.C[0].is_zero());
    for (unsigned j = 0; j <= order; ++j) {
        CAPTURE(j);
        CHECK(holds(found.C, j, c[j], found.C[0]));
        CHECK(holds(found.B, j, b[j], found.C[0]));
    }
}

std::string negative(const std::string& formula) {
    return "-(" + formula + ")";
}

}  // namespace

TEST_CASE("Table 1, orders 1 to 3, and order 4 with I_9 corrected") {
    check_row({"1", "1"}, {"-2*a1/dX", "2*a1/dX"});
    check_row({"1", I1, "1"}, {I2, "0", negative(I2)});
    check_row({"1", I3, I3, "1"}, {I4, I5, negative(I5), negative(I4)});
    check_row({"1", I6, I7, I6, "1"},
              {I8, I9_corrected, "0", negative(I9_corrected), negative(I8)});
}

TEST_CASE("I_9 as printed does not hold: a_1^2 dX^6 should be a_1^3 dX^6") {
    const MatchingPolynomials found = general(4);
    CHECK_FALSE(holds(found.B, 1, I9_printed, found.C[0]));
    // As printed it is not even homogeneous: b_1 is of degree 1 in the a_k together.
    const GiNaC::symbol t("t");
    const GiNaC::exmap scaled{{a1, t * a1}, {a3, t * a3}, {a5, t * a5}, {a7, t * a7}};
    CHECK_FALSE(identical(printed_ratio(I9_printed).subs(scaled), t * printed_ratio(I9_printed)));
    CHECK(identical(printed_ratio(I9_corrected).subs(scaled), t * printed_ratio(I9_corrected)));
    // With a_1 = 1, the only value at c = 1, the two cannot be told apart.
    CHECK(identical(printed_ratio(I9_printed).subs(a1 == 1),
                    printed_ratio(I9_corrected).subs(a1 == 1)));
}

TEST_CASE("Table 1 at random numbers, against the system (49) solved as printed") {
    // A second way that uses neither match() nor symbolic simplification.
    std::mt19937_64 random(20180417);
    std::uniform_int_distribution<int> numerator(-9, 9);
    std::uniform_int_distribution<int> denominator(1, 9);
    const auto draw = [&] { return Rational(numerator(random), denominator(random)); };
    int compared = 0;
    for (int instance = 0; instance < 200; ++instance) {
        const std::vector<Rational> a{0, draw(), 0, draw(), 0, draw(), 0, draw(), 0};
        const Rational spacing = abs(draw()) + 1;
        const auto solution = solve_literally(a, spacing, 4);
        if (!solution) {
            continue;
        }
        const GiNaC::lst values{a1 == to_ginac(a[1]), a3 == to_ginac(a[3]), a5 == to_ginac(a[5]),
                                a7 == to_ginac(a[7]), dX_of_table == to_ginac(spacing)};
        const auto value = [&values](const std::string& formula) {
            return printed_ratio(formula).subs(values);
        };
        CHECK(value(I6).is_equal(to_ginac((*solution)[1])));
        CHECK(value(I7).is_equal(to_ginac((*solution)[2])));
        CHECK(value(I8).is_equal(to_ginac((*solution)[5])));
        CHECK(value(I9_corrected).is_equal(to_ginac((*solution)[6])));
        if (a[1] * (a[1] - 1) != 0) {
            CHECK_FALSE(value(I9_printed).is_equal(to_ginac((*solution)[6])));
        }
        ++compared;
    }
    CHECK(compared > 150);
}
