// SPDX-License-Identifier: GPL-2.0-or-later
/// Grades and verdicts at single G: beside values with C(1) = 0, and where what is amplified is
/// narrow, in G or in the band.
#include <doctest/doctest.h>

#include <algorithm>

#include "generator/exact/algebraic_number.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/certify.hpp"
#include "generator/stability/critical_values.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/modal.hpp"

namespace {

using nmbcgen::AlgebraicNumber;
using nmbcgen::Failure;
using nmbcgen::Rational;
using nmbcgen::Table;

// A value with C(1) = 0 is never inside a window. Matching makes s = B/C of long waves, y -> 0, the
// s = 2 y of the interior, O(0) = 2 E(0); so where E(0) changes sign, a root w of O = -2 E passes
// through 0. On one side it is a mode that grows, on the other a travelling wave sent out by
// itself.
TEST_CASE("on both sides of C(1) = 0 a mode grows or a wave resonates") {
    struct Condition {
        unsigned horizon, order, stride;
    };
    for (const Condition& each :
         {Condition{1, 3, 1}, Condition{1, 4, 1}, Condition{2, 3, 1}, Condition{2, 4, 1},
          Condition{2, 3, 2}, Condition{2, 4, 2}, Condition{3, 3, 1}, Condition{3, 3, 3}}) {
        CAPTURE(each.horizon);
        CAPTURE(each.order);
        CAPTURE(each.stride);
        const auto table =
            nmbcgen::derive({"nopd1d", each.horizon, each.order, each.stride, std::nullopt});
        const auto values = jordan_values(even_and_odd_parts(table));
        CHECK_FALSE(values.empty());
        for (const AlgebraicNumber& value : values) {
            for (const double aside : {1 - 1e-4, 1 + 1e-4}) {
                const double G = nearest_double(value) * aside;
                CAPTURE(G);
                const auto failure =
                    nmbcgen::modal_verdict(nmbcgen::make_half_space(table, Rational(G))).failure;
                const bool sends_by_itself =
                    failure == Failure::growing_mode || failure == Failure::resonance;
                CHECK(sends_by_itself);
            }
        }
    }
}

// About G = 2.28 two extrema of the band change their order. The band between them is narrower than
// 1e-9 of it over 0.006 of G, and in it waves are amplified by up to 6.7e-6 where one end meets any
// other. Just below G* = 2.448 steps of cfl 0.86 amplify waves by up to 5.9e-4.
TEST_CASE("what is narrow in the band or in G is no window, and limits the steps") {
    const auto certificate = nmbcgen::certify(nmbcgen::derive({"nopd1d", 5, 1, 5, {}}));
    const double least_contractive = certificate.contractive.front().low.inner;
    CHECK(least_contractive > 2.448);
    CHECK(certificate.max_cfl_contractive.front().window.low >= least_contractive);
    for (const double G : {2.44, 2.443, 2.4432, 2.445, 2.448}) {
        const auto half_space =
            nmbcgen::make_half_space(nmbcgen::derive({"nopd1d", 5, 1, 5, {}}), Rational(G));
        const auto piece = std::ranges::find_if(
            certificate.max_cfl, [G](const auto& steps) { return G <= steps.window.high; });
        REQUIRE(piece != certificate.max_cfl.end());
        CHECK(piece->cfl <= nmbcgen::stable_range(half_space).largest);
    }
}

// Where they meet, at G = 2.28 but for 2e-5, it is narrower than roundings: 4e-17 at G = 57/25, and
// sigma_max - 1 is 1.7e-10 in it, by 60 digits. sup rho is below 1 there in continuous time.
TEST_CASE("what is too narrow in the band for doubles is not contractive where it amplifies") {
    for (const Rational& G : {Rational(227, 100), Rational(22765, 10000), Rational(2279, 1000),
                              Rational(57, 25), Rational(22801, 10000), Rational(2283, 1000)}) {
        CAPTURE(G);
        const auto half_space =
            nmbcgen::make_half_space(nmbcgen::derive({"nopd1d", 5, 1, 5, {}}), G);
        CHECK(nmbcgen::stability_grade(half_space) == nmbcgen::Grade::paired);
        CHECK(!nmbcgen::modal_verdict(half_space).contractive);
        // 0.91 at G = 2.27 and 2.29
        CHECK(nmbcgen::stable_range(half_space).largest == doctest::Approx(0.91));
    }
}

// Next to an extremum of the band sigma_max - 1 is a number times the root of the distance. By 70
// digits that number changes its sign at the G below. Doubles in which the energy flux of two waves
// that meet has roundings of its own found 1 + 1e-6 up to 6e-4 before it.
TEST_CASE("waves that meet at an extremum are contractive up to where sigma_max leaves 1") {
    struct Condition {
        unsigned horizon, order, stride;
        double end;
    };
    for (const Condition& condition :
         {Condition{2, 3, 1, 1.8866070877}, Condition{2, 2, 4, 0.1866286775},
          Condition{3, 1, 3, 11.1363908749}, Condition{3, 2, 3, 4.0265227645}}) {
        CAPTURE(condition.horizon);
        CAPTURE(condition.order);
        const auto& [horizon, order, stride, end] = condition;
        const Table table = nmbcgen::derive({"nopd1d", horizon, order, stride, std::nullopt});
        const auto grade_at = [&](double G) {
            return nmbcgen::stability_grade(nmbcgen::make_half_space(table, Rational(G)));
        };
        for (const double before : {1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 2e-6}) {
            CAPTURE(before);
            CHECK(grade_at(end * (1 - before)) == nmbcgen::Grade::contractive);
        }
        CHECK(grade_at(end * (1 + 2e-6)) == nmbcgen::Grade::paired);
    }
}

// sup rho is 1 + 3.2e-4 in a summit that is not beside the best of the samples; n = 3, damped: 9.5,
// in a summit 1e-5 of its frequency wide.
TEST_CASE("every summit of what is amplified is looked at") {
    const auto grade_at = [](nmbcgen::Specification what, const Rational& step, const Rational& G) {
        what.time_step = step;
        return nmbcgen::stability_grade(nmbcgen::make_half_space(nmbcgen::derive(what), G));
    };
    const nmbcgen::Specification undamped{"nopd1d", 2, 3, 2, {}};
    CHECK(grade_at(undamped, 1, Rational(20129, 10000)) == nmbcgen::Grade::paired);
    CHECK(grade_at(undamped, 1, Rational(2012913, 1000000)) == nmbcgen::Grade::none);
    const nmbcgen::Specification damped{"nopd1d", 3, 2, 4, {}, Rational(1, 10)};
    CHECK(grade_at(damped, Rational(3, 2), Rational(7554, 10000)) == nmbcgen::Grade::paired);
    CHECK(grade_at(damped, Rational(3, 2), Rational(756, 1000)) == nmbcgen::Grade::none);
}

}  // namespace
