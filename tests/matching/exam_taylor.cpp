// SPDX-License-Identifier: GPL-2.0-or-later
/// The Taylor coefficients of (47) against the closed forms of appendix A of Nicely 2018: which
/// hold as printed, which only when corrected. n = 1 .. 6, identically in G, dX and c.
#include <doctest/doctest.h>
#include <ginac/ginac.h>

#include <stdexcept>

#include "tests/support/appendix.hpp"
#include "tests/support/printed.hpp"
#include "tests/support/taylor.hpp"

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::pow;
using namespace nmbcgen::test;

namespace {

const GiNaC::symbol c("c");
const GiNaC::symbol dX("dX");
const GiNaC::symbol G("G");

/// a_k from the symbol, in the paper's units: omega = (c/dX) f(xi dX; G/dX).
ex derived(int n, unsigned k, const ex& stabilisation) {
    const GiNaC::symbol own("G");
    const ex a = nopd1d_taylor(unsigned(n), own, k).at(k);
    return c * pow(dX, int(k) - 1) * a.subs(own == stabilisation / dX);
}

ex printed(const std::string& formula, int n) {
    return Reader({{"n", numeric(n)}, {"c", c}, {"dX", dX}, {"G", G}})(formula);
}

bool standard_holds(const std::string& formula, int n, unsigned k) {
    return identical(printed(formula, n), derived(n, k, 0));
}

bool stabilised_holds(const ex& formula, int n, unsigned k) {
    return identical(formula, derived(n, k, G));
}

}  // namespace

TEST_CASE("a_1 = c and the even coefficients vanish") {
    for (int n = 1; n <= 6; ++n) {
        CAPTURE(n);
        CHECK(identical(derived(n, 1, G), c));
        for (const unsigned even : {0U, 2U, 4U, 6U, 8U}) {
            CHECK(derived(n, even, G).is_zero());
        }
    }
}

TEST_CASE("standard a_3 and a_5 hold as printed") {
    for (int n = 1; n <= 6; ++n) {
        CAPTURE(n);
        CHECK(standard_holds(standard_a3, n, 3));
        CHECK(standard_holds(standard_a5, n, 5));
    }
}

TEST_CASE("standard a_7: the prefactor c/15 fails, c/75600 holds") {
    for (int n = 1; n <= 6; ++n) {
        CAPTURE(n);
        CHECK_FALSE(standard_holds("c/15*" + standard_a7_bracket, n, 7));
        CHECK(standard_holds("c/75600*" + standard_a7_bracket, n, 7));
    }
}

TEST_CASE("stabilised a_3: fails as printed, holds with -G for G") {
    for (int n = 1; n <= 6; ++n) {
        CAPTURE(n);
        const ex as_printed = printed(stabilised_a3, n);
        CHECK_FALSE(stabilised_holds(as_printed, n, 3));
        CHECK(stabilised_holds(as_printed.subs(G == -G), n, 3));
        CHECK(standard_holds(standard_a3, n, 3));  // at G = 0 both agree
        CHECK(identical(as_printed.subs(G == 0), printed(standard_a3, n)));
    }
}

TEST_CASE("stabilised a_5: fails as printed for n >= 2, holds with -G for G") {
    for (int n = 1; n <= 6; ++n) {
        CAPTURE(n);
        const ex as_printed = printed(stabilised_a5, n);
        // The term linear in G has the factor n - 1, so that n = 1 cannot tell the signs apart.
        CHECK(stabilised_holds(as_printed, n, 5) == (n == 1));
        CHECK(stabilised_holds(as_printed.subs(G == -G), n, 5));
        CHECK(identical(as_printed.subs(G == 0), printed(standard_a5, n)));
    }
}

TEST_CASE("stabilised a_7 holds as printed") {
    for (int n = 1; n <= 6; ++n) {
        CAPTURE(n);
        CHECK(stabilised_holds(printed(stabilised_a7, n), n, 7));
        CHECK_FALSE(stabilised_holds(printed(stabilised_a7, n).subs(G == -G), n, 7));
        // At G = 0 it has the prefactor that the standard a_7 lacks in print.
        CHECK(identical(printed(stabilised_a7, n).subs(G == 0),
                        printed("c/75600*" + standard_a7_bracket, n)));
    }
}

TEST_CASE("n = 1, worked by hand") {
    // omega^2 = sin^2 + 2G(1-cos)^2 = xi^2 - (1/3 - G/2) xi^4 + (2/45 - G/12) xi^6
    //           - (1/315 - G/160) xi^8 + ..; the square root is
    // omega = xi - a_3 xi^3 + a_5 xi^5 - a_7 xi^7 + ..
    const GiNaC::symbol own("G");
    const auto a = nopd1d_taylor(1, own, 7);
    const ex third = numeric(1, 6) - own / 4;
    const ex fifth = numeric(1, 120) - pow(own, 2) / 32;
    const ex seventh = numeric(1, 5040) - own / 960 + pow(own, 2) / 192 - pow(own, 3) / 128;
    CHECK(identical(a[3], third));
    CHECK(identical(a[5], fifth));
    CHECK(identical(a[7], seventh));
    CHECK(identical(2 * third, numeric(1, 3) - own / 2));
    CHECK(identical(2 * fifth + pow(third, 2), numeric(2, 45) - own / 12));
    CHECK(identical(2 * seventh + 2 * third * fifth, numeric(1, 315) - own / 160));
    // G = 1/2 is the atom chain: omega = 2 sin(xi/2), a_k = 2 / (2^k k!).
    for (const int k : {1, 3, 5, 7}) {
        CHECK(identical(a[unsigned(k)].subs(own == numeric(1, 2)),
                        2 / (pow(numeric(2), k) * GiNaC::factorial(k))));
    }
}

TEST_CASE("n = 1 with damping, worked by hand") {
    // With x = i xi: sigma = 2(1 - cos)^2 = x^4/2 + x^6/12 + .., s = x + a_3 x^3 + a_4 x^4 + ..;
    // the powers 5, 7 and 8 of s^2 + tau sigma s + omega^2 are
    //     2 a_4 + tau/2,   2 a_6 + 2 a_3 a_4 + tau (a_3/2 + 1/12),
    //     2 a_7 + 2 a_3 a_5 + a_4^2 + tau a_4/2 + what is there without damping.
    const GiNaC::symbol tau("tau");
    const auto plain = nopd1d_taylor(1, G, 7);
    const auto a = nopd1d_taylor(1, G, 7, tau);
    CHECK(a[2].is_zero());
    CHECK(identical(a[3], plain[3]));
    CHECK(identical(a[4], -tau / 4));
    CHECK(identical(a[5], plain[5]));
    CHECK(identical(a[6], -tau / 24));
    CHECK(identical(a[7], plain[7] + pow(tau, 2) / 32));
}

TEST_CASE("a damped rigid motion is refused") {
    CHECK_THROWS_AS(nmbcgen::taylor_coefficients({{2, -1}, {1}}, 3), std::invalid_argument);
    CHECK_THROWS_AS(nmbcgen::taylor_coefficients({{2, -1}, {3, -1}}, 3), std::invalid_argument);
    // tau sigma = xi^2 + ..: s = x + x^2/2 + ..
    CHECK(nmbcgen::taylor_coefficients({{2, -1}, {2, -1}}, 3)[2].is_equal(numeric(1, 2)));
}

TEST_CASE("a symbol that does not start as xi^2 is refused") {
    // omega^2 = 1: no acoustic branch. omega^2 = 2(2 - z - 1/z) = 2 xi^2 + ..: c is not 1.
    CHECK_THROWS_AS(nmbcgen::taylor_coefficients({{1, 0}, {}}, 3), std::invalid_argument);
    CHECK_THROWS_AS(nmbcgen::taylor_coefficients({{4, -2}, {}}, 3), std::invalid_argument);
    CHECK(
        nmbcgen::taylor_coefficients({{2, -1}, {}}, 3)[3].is_equal(numeric(1, 24)));  // 2 sin(xi/2)
}
