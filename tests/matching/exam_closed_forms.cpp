// SPDX-License-Identifier: GPL-2.0-or-later
/// Closed forms in the horizon: against the expansion at every one of twelve horizons, against the
/// printed ones identically in n and G, and that nothing wrong is proved.
#include <doctest/doctest.h>
#include <ginac/ginac.h>

#include "generator/commands/closed_forms.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/matching/closed_taylor.hpp"
#include "generator/matching/freeze.hpp"
#include "tests/support/appendix.hpp"
#include "tests/support/printed.hpp"
#include "tests/support/taylor.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

const GiNaC::symbol n("n");
const GiNaC::symbol G("G");

/// a_{2j+1} in n and G.
GiNaC::ex closed(const ClosedForms& taylor, std::size_t j) {
    GiNaC::ex sum = 0;
    for (std::size_t g = 0; g < taylor.functions.at(j).size(); ++g) {
        sum += thaw(taylor.functions[j][g], n) * pow(G / pow(n, int(taylor.pole)), int(g));
    }
    return sum;
}

/// The printed formula at dX = c = 1.
GiNaC::ex printed(const std::string& formula) {
    return Reader({{"n", n}, {"c", 1}, {"dX", 1}, {"G", G}})(formula);
}

bool is_proved(const ClosedForms& taylor) {
    try {
        prove_closed_taylor("nopd1d", taylor);
        return true;
    } catch (const std::logic_error& error) {
        CHECK(std::string(error.what()).find("not proved") == 0);
        return false;
    }
}

/// (n - 1)(n - 2) .. (n - last): zero at all these horizons.
Polynomial zero_up_to(unsigned last) {
    Polynomial product = constant(1);
    for (unsigned horizon = 1; horizon <= last; ++horizon) {
        product *= Polynomial(std::vector<Rational>{-Rational(horizon), 1});
    }
    return product;
}

}  // namespace

TEST_CASE("closed forms at n = 1 .. 12 are the Taylor coefficients of the model") {
    const unsigned order = 5;
    const ClosedForms taylor = closed_forms(find_family("nopd1d"), order).taylor;
    REQUIRE(taylor.functions.size() == order + 1);
    for (unsigned horizon = 1; horizon <= 12; ++horizon) {
        CAPTURE(horizon);
        const auto direct = nopd1d_taylor(horizon, G, 2 * order + 1);
        for (unsigned j = 0; j <= order; ++j) {
            CHECK(at_horizon(taylor.functions[j], taylor.pole, horizon) ==
                  freeze(direct[2 * j + 1], G));
        }
    }
}

TEST_CASE("identically in n and G they are the printed ones, corrected") {
    const ClosedForms taylor = closed_forms(find_family("nopd1d"), 3).taylor;
    const GiNaC::ex a_3 = closed(taylor, 1);
    const GiNaC::ex a_5 = closed(taylor, 2);
    const GiNaC::ex a_7 = closed(taylor, 3);
    CHECK(identical(closed(taylor, 0), 1));
    // Standard: a_7 has another prefactor.
    CHECK(identical(a_3.subs(G == 0), printed(standard_a3)));
    CHECK(identical(a_5.subs(G == 0), printed(standard_a5)));
    CHECK(identical(a_7.subs(G == 0), printed("c/75600*" + standard_a7_bracket)));
    CHECK_FALSE(identical(a_7.subs(G == 0), printed("c/15*" + standard_a7_bracket)));
    // Stabilised: a_3 and a_5 have the other sign at odd powers of G.
    CHECK(identical(a_3, printed(stabilised_a3).subs(G == -G)));
    CHECK(identical(a_5, printed(stabilised_a5).subs(G == -G)));
    CHECK(identical(a_7, printed(stabilised_a7)));
    CHECK_FALSE(identical(a_3, printed(stabilised_a3)));
    CHECK_FALSE(identical(a_5, printed(stabilised_a5)));
    CHECK_FALSE(identical(a_7, printed(stabilised_a7).subs(G == -G)));
}

TEST_CASE("any wrong coefficient of a moment fails the proof") {
    const ClosedForms right = nopd1d_moments(4);
    REQUIRE(is_proved(closed_taylor(right)));
    for (std::size_t k = 1; k < right.functions.size(); ++k) {  // x^2 has to be xi^2
        for (std::size_t g = 0; g < right.functions[k].size(); ++g) {
            for (std::size_t power = 0; power < right.functions[k][g].size(); ++power) {
                ClosedForms wrong = right;
                wrong.functions[k][g][power] += Rational(1, 1000000);
                CAPTURE(k);
                CAPTURE(g);
                CAPTURE(power);
                CHECK_FALSE(is_proved(closed_taylor(wrong)));
            }
        }
    }
}

TEST_CASE("any wrong coefficient of a_k fails the proof") {
    const ClosedForms right = closed_forms(find_family("nopd1d"), 3).taylor;
    for (std::size_t j = 0; j < right.functions.size(); ++j) {
        for (std::size_t g = 0; g < right.functions[j].size(); ++g) {
            for (std::size_t power = 0; power < right.functions[j][g].size(); ++power) {
                ClosedForms wrong = right;
                wrong.functions[j][g][power] -= Rational(1, 1000000);
                CAPTURE(j);
                CAPTURE(g);
                CAPTURE(power);
                CHECK_FALSE(is_proved(wrong));
            }
        }
    }
    ClosedForms wrong = right;
    wrong.pole = 4;
    CHECK_FALSE(is_proved(wrong));
    wrong = right;
    wrong.functions.resize(1);
    CHECK_FALSE(is_proved(wrong));
}

TEST_CASE("what is right at the horizons tried, and wrong beyond, is not proved") {
    // Orders 1 to 3 are tried at 6, 11 and 16 horizons.
    for (const unsigned order : {1U, 2U, 3U}) {
        const ClosedForms right = closed_forms(find_family("nopd1d"), order).taylor;
        for (std::size_t g = 0; g < right.functions[order].size(); ++g) {
            CAPTURE(order);
            CAPTURE(g);
            ClosedForms wrong = right;
            wrong.functions[order][g] += zero_up_to(5 * order + 1);
            CHECK_FALSE(is_proved(wrong));
        }
        ClosedForms another_power = right;
        another_power.functions[order].push_back(zero_up_to(5 * order + 1));
        CHECK_FALSE(is_proved(another_power));
    }
}

TEST_CASE("the moments have the degrees that the proof rests on") {
    const ClosedForms moments = nopd1d_moments(8);
    for (std::size_t k = 1; k <= moments.functions.size(); ++k) {
        for (std::size_t g = 0; g < moments.functions[k - 1].size(); ++g) {
            CHECK(moments.functions[k - 1][g].size() <= 2 * k - 1 + moments.pole * g);
        }
    }
}

TEST_CASE("a family without closed forms is refused") {
    CHECK_THROWS_WITH_AS(closed_forms(Family{"other", nopd1d, nullptr}, 1),
                         "no closed forms in the horizon are known of family 'other'",
                         NoClosedForms);
    CHECK_THROWS_AS(find_family("other"), std::invalid_argument);
}

TEST_CASE("a_3 vanishes at G = 4 n^3 / ((n+1)(2n+1)), and a_5 does not") {
    const ClosedForms taylor = closed_forms(find_family("nopd1d"), 2).taylor;
    const GiNaC::ex where = 4 * pow(n, 3) / ((n + 1) * (2 * n + 1));
    const GiNaC::ex a_3 = closed(taylor, 1);
    CHECK(identical(a_3, (3 * n * n + 3 * n - 1) / 30 * (1 - G / where)));
    // a_5 does not vanish with it: all of its Taylor coefficients at n = 1 are negative.
    const GiNaC::ex left =
        -12600 * closed(taylor, 2).subs(G == where).subs(n == n + 1).normal().expand();
    CHECK(identical(
        left, 26 * pow(n + 1, 4) + 52 * pow(n + 1, 3) + 7 * pow(n + 1, 2) - 19 * (n + 1) + 4));
    const Polynomial shifted = freeze(left.normal(), n);
    for (const Rational& coefficient : shifted.data()) {
        CHECK(coefficient > 0);
    }
}

TEST_CASE("the limit of many neighbours, dX = delta/n, G = Gamma n") {
    // a_k dX^(k-1) -> delta^(k-1) times the coefficient of n^(k-1).
    const ClosedForms taylor = closed_forms(find_family("nopd1d"), 2).taylor;
    const GiNaC::symbol ratio("Gamma");
    const auto limit = [&](std::size_t j) {
        const GiNaC::ex scaled =
            (closed(taylor, j).subs(G == ratio * n) / pow(n, int(2 * j))).expand();
        CHECK(scaled.degree(n) == 0);
        return scaled.coeff(n, 0);
    };
    CHECK(identical(limit(1), GiNaC::numeric(1, 10) - ratio / 20));
    CHECK(identical(limit(2), GiNaC::numeric(1, 280) - ratio / 3150 - pow(ratio, 2) / 800));
}
