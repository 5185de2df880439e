// SPDX-License-Identifier: GPL-2.0-or-later
/// match() against the system (49) solved as printed, on random Taylor coefficients.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <random>

#include "generator/exact/rational_function.hpp"
#include "generator/matching/matching.hpp"
#include "generator/pipeline.hpp"
#include "tests/support/generators.hpp"
#include "tests/support/literal_system.hpp"
#include "tests/support/printed.hpp"
#include "tests/support/taylor.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

/// a_0 .. a_2N with random entries, with step 2 odd ones only; a_1 > 0, as for every model that
/// carries waves.
std::vector<Rational> random_taylor(unsigned order, unsigned step) {
    std::vector<Rational> a(2 * order + 1, Rational(0));
    a[1] = *positive_rational();
    for (std::size_t k = 1 + step; k < a.size(); k += step) {
        a[k] = *small_rational();
    }
    return a;
}

MatchingPolynomials matched(const std::vector<Rational>& a, const Rational& dX, unsigned order) {
    std::vector<GiNaC::ex> taylor;
    taylor.reserve(a.size());
    for (const Rational& coefficient : a) {
        taylor.emplace_back(to_ginac(coefficient));
    }
    return match(taylor, to_ginac(dX), order);
}

/// c_0 .. c_N, b_0 .. b_N from the polynomials.
std::vector<Rational> normalised(const MatchingPolynomials& found) {
    std::vector<Rational> all = to_rationals(found.C);
    const std::vector<Rational> b = to_rationals(found.B);
    const Rational first = all.front();
    all.insert(all.end(), b.begin(), b.end());
    for (Rational& value : all) {
        value /= first;
    }
    return all;
}

}  // namespace

TEST_CASE("random Taylor coefficients, orders 1 to 5, random strides") {
    CHECK(rc::check("the solution of (49), or its singularity", [] {
        const unsigned order = *rc::gen::inRange(1U, 6U);
        const unsigned stride = *rc::gen::inRange(1U, 5U);
        const Rational dX = int(stride) * *positive_rational();
        const auto a = random_taylor(order, *rc::gen::inRange(1U, 3U));
        const auto solution = solve_literally(a, dX, order);
        const auto found = matched(a, dX, order);
        const Degeneracy reported = degeneracy(found);
        const bool solvable =
            reported == Degeneracy::none || reported == Degeneracy::vanishing_at_one;
        RC_TAG(solvable);
        RC_ASSERT(solution.has_value() == solvable);
        if (solution) {
            RC_ASSERT(normalised(found) == *solution);
        }
    }));
}

TEST_CASE("small whole Taylor coefficients, which are often degenerate") {
    // a_3, a_5, a_7 in multiples of 1/720 small enough to hit poles, blocks and lower orders.
    int none = 0;
    int singular = 0;
    for (int third = -4; third <= 4; ++third) {
        for (int fifth = -6; fifth <= 6; ++fifth) {
            for (const unsigned order : {2U, 3U}) {
                const std::vector<Rational> a{0, 1, 0, Rational(third, 12), 0, Rational(fifth, 120),
                                              0, 0, 0};
                const auto found = matched(a, 1, order);
                const Degeneracy reported = degeneracy(found);
                const auto solution = solve_literally(a, 1, order);
                const bool solvable =
                    reported == Degeneracy::none || reported == Degeneracy::vanishing_at_one;
                CAPTURE(third);
                CAPTURE(fifth);
                REQUIRE(solution.has_value() == solvable);
                if (solution) {
                    REQUIRE(normalised(found) == *solution);
                }
                none += int(reported == Degeneracy::none);
                singular += int(!solvable);
            }
        }
    }
    CHECK(none > 100);
    CHECK(singular > 10);
}

TEST_CASE("the same with even ones, as damping makes them") {
    int none = 0;
    int vanishing = 0;
    int both = 0;
    int singular = 0;
    for (int second = -2; second <= 2; ++second) {
        for (int third = -4; third <= 4; ++third) {
            for (int fourth = -4; fourth <= 4; ++fourth) {
                const std::vector<Rational> a{0, 1, Rational(second, 2), Rational(third, 12),
                                              Rational(fourth, 24)};
                const auto found = matched(a, 1, 2);
                const Degeneracy reported = degeneracy(found);
                const auto solution = solve_literally(a, 1, 2);
                CAPTURE(second);
                CAPTURE(third);
                CAPTURE(fourth);
                // Here C(1) = 0 can come together with c_0 = 0.
                const bool solvable =
                    reported == Degeneracy::none ||
                    (reported == Degeneracy::vanishing_at_one && !found.C.front().is_zero());
                REQUIRE(solution.has_value() == solvable);
                if (solution) {
                    REQUIRE(normalised(found) == *solution);
                }
                none += int(reported == Degeneracy::none);
                vanishing += int(reported == Degeneracy::vanishing_at_one);
                both += int(reported == Degeneracy::vanishing_at_one && !solvable);
                singular += int(!solvable);
            }
        }
    }
    CHECK(none > 300);
    CHECK(vanishing > 5);
    CHECK(both > 0);
    CHECK(singular > 5);
}

TEST_CASE("the tables of the model, at random G, orders, strides and dampings") {
    CHECK(rc::check("derive() solves (49)", [] {
        Specification what{.family = "nopd1d",
                           .horizon = *rc::gen::inRange(1U, 6U),
                           .order = *rc::gen::inRange(1U, 6U),
                           .stride = *rc::gen::inRange(1U, 4U),
                           .stabilisation = *positive_rational()};
        if (*rc::gen::arbitrary<bool>()) {
            what.damping = *positive_damping();
        }
        const auto taylor = nopd1d_taylor(what.horizon, to_ginac(*what.stabilisation),
                                          2 * what.order, to_ginac(what.damping));
        const auto solution =
            solve_literally(to_rationals(taylor), Rational(int(what.stride)), what.order);
        try {
            const Table table = derive(what);
            RC_ASSERT(solution.has_value());
            for (std::size_t j = 0; j <= what.order; ++j) {
                const ExactFunction c = to_rational_function(constant((*solution)[j]));
                const ExactFunction b =
                    to_rational_function(constant((*solution)[what.order + 1 + j]));
                RC_ASSERT(table.c[j] == c);
                RC_ASSERT(table.b[j] == b);
            }
        } catch (const NoSuchBoundary&) {
            // Refused: singular, or C(1) = 0.
            Rational sum = 0;
            for (std::size_t j = 0; solution && j <= what.order; ++j) {
                sum += (*solution)[j];
            }
            RC_ASSERT(sum == 0);
        }
    }));
}
