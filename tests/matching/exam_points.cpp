// SPDX-License-Identifier: GPL-2.0-or-later
/// Matching points besides xi = 0: closed forms by hand, what does not exist, and that the proof
/// sees a wrong digit.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/matching/proof.hpp"
#include "generator/pipeline.hpp"
#include "tests/support/contains.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

MatchingPoint point(const Rational& wave_number, unsigned multiplicity) {
    return {.wave_number = wave_number, .of_pi = false, .multiplicity = multiplicity};
}

MatchingPoint part_of_pi(const Rational& part, unsigned multiplicity) {
    return {.wave_number = part, .of_pi = true, .multiplicity = multiplicity};
}

/// At n = 1, G = 1/2, which is the atom chain, omega = 2 sin(xi/2).
Specification chain(unsigned order, std::vector<MatchingPoint> points) {
    return {
        .horizon = 1, .order = order, .stabilisation = Rational(1, 2), .points = std::move(points)};
}

double c_of(const Table& table, std::size_t j) {
    return nearest_double(evaluate(table.c[j], 0));
}

double b(const Table& table, std::size_t j) {
    return nearest_double(evaluate(table.b[j], 0));
}

std::string objection(const Specification& specification) {
    try {
        derive(specification);
        return "";
    } catch (const NoSuchBoundary& reason) {
        return reason.what();
    }
}

}  // namespace

TEST_CASE("NMBC1 of the atom chain, matched at one wave number") {
    // 2 sin(xi/2) cos(xi/2) = b sin(xi/2): b = 2 cos(xi/2).
    const Table third = derive(chain(1, {part_of_pi(Rational(1, 3), 1)}));
    CHECK(third.digits == 40);
    CHECK(c_of(third, 1) == 1);
    CHECK(b(third, 0) == -std::sqrt(3.0));
    CHECK(b(third, 1) == std::sqrt(3.0));

    const Table two_thirds = derive(chain(1, {part_of_pi(Rational(2, 3), 1)}));
    CHECK(evaluate(two_thirds.b[1], 0) == 1);

    const Table at_one = derive(chain(1, {point(1, 1)}));
    // Two roundings of the right-hand side.
    CHECK(b(at_one, 1) == doctest::Approx(2 * std::cos(0.5)).epsilon(1e-15).scale(0));
}

TEST_CASE("NMBC2 of the atom chain, matched at 0 and at pi/3") {
    // omega (c + 2 cos xi) = 2 b sin xi, c + 2 = 2 b at xi = 0 (rows up to 2 of (49)) and
    // c + 1 = b sqrt(3) at pi/3: b = 2 + sqrt(3), c = 2 + 2 sqrt(3).
    const Table table = derive(chain(2, {part_of_pi(Rational(1, 3), 1)}));
    CHECK(c_of(table, 1) == 2 + 2 * std::sqrt(3.0));
    CHECK(b(table, 2) == 2 + std::sqrt(3.0));
    CHECK(evaluate(table.b[1], 0) == 0);
    CHECK(evaluate(table.c[1], 0) + 2 == 2 * evaluate(table.b[2], 0));  // exactly
}

TEST_CASE("points that run together") {
    // A point at distance e moves a coefficient by O(e^2): twice as near, a quarter of it.
    for (const Rational& tau : {Rational(0), Rational(1, 10)}) {
        Specification what = chain(3, {point(1, 2)});
        what.damping = tau;
        const double double_point = c_of(derive(what), 1);
        const auto split = [&](const Rational& e) {
            what.points = {point(1 - e, 1), point(1 + e, 1)};
            return c_of(derive(what), 1) - double_point;
        };
        const double near = split(Rational(1, 200));
        CHECK(std::abs(near) > 1e-6);  // not a matter of roundings
        // The next term is of order e^2 of it: 1e-4, times a constant of order one.
        CHECK(split(Rational(1, 100)) / near == doctest::Approx(4).epsilon(1e-3).scale(0));
    }
    Specification what = chain(2, {point(Rational(1, 100), 1)});
    const Table standard = derive(chain(2, {}));
    const double far = c_of(derive(what), 1) - c_of(standard, 1);
    what.points = {point(Rational(1, 200), 1)};
    CHECK(far / (c_of(derive(what), 1) - c_of(standard, 1)) ==
          doctest::Approx(4).epsilon(1e-3).scale(0));
}

TEST_CASE("symmetric without damping, in strides and in steps; not with damping") {
    Specification what{.horizon = 2,
                       .order = 4,
                       .stride = 2,
                       .stabilisation = Rational(1),
                       .time_step = Rational(1, 2),
                       .points = {point(Rational(1, 4), 1), point(Rational(1, 2), 1)}};
    const Table table = derive(what);
    for (std::size_t j = 0; j <= 4; ++j) {
        CHECK(table.c[j] == table.c[4 - j]);
        CHECK(evaluate(table.b[j], 0) == -evaluate(table.b[4 - j], 0));
    }
    what.damping = Rational(1, 10);
    CHECK(derive(what).c[0] != derive(what).c[4]);
}

TEST_CASE("what does not exist says why") {
    // n = 1, G = 0: omega = sin xi has its top at pi/2.
    Specification what{.horizon = 1,
                       .order = 2,
                       .stabilisation = Rational(0),
                       .points = {part_of_pi(Rational(1, 2), 1)}};
    CHECK(contains(objection(what), "group velocity is zero"));
    what = chain(2, {part_of_pi(Rational(1, 2), 1)});
    what.stride = 2;
    CHECK(contains(objection(what), "looks like one of xi = 0 or pi"));
    what = chain(2, {point(Rational(23, 10), 1)});
    what.damping = 2;
    CHECK(contains(objection(what), "no wave travels"));
    // n = 1, G = 0: i omega = (z^2 - 1)/(2z) meets all equations, with c_0 = 0; so does each of its
    // multiples by a symmetric polynomial: of order 3 by z + 1 alone, of order 4 by many.
    what = {.horizon = 1,
            .order = 3,
            .stabilisation = Rational(0),
            .points = {point(Rational(1, 2), 1)}};
    CHECK(contains(objection(what), "pole"));
    what.order = 4;
    CHECK(contains(objection(what), "singular"));
    what = chain(1, {point(1, 2)});
    CHECK_THROWS_AS(derive(what), std::invalid_argument);
    what = chain(2, {point(1, 1), point(1, 1)});
    CHECK_THROWS_AS(derive(what), std::invalid_argument);
    what = chain(2, {point(4, 1)});
    CHECK_THROWS_AS(derive(what), std::invalid_argument);
    what = chain(2, {point(1, 1)});
    what.stabilisation.reset();
    CHECK_THROWS_AS(derive(what), std::invalid_argument);
}

TEST_CASE("a condition that has C = B = 0 at its point is none") {
    // n = 1, G = 1: NMBC1 meets (49) to 5 rows, so that it times z^2 + 1 meets them and pi/2.
    Specification what{.horizon = 1,
                       .order = 3,
                       .stabilisation = Rational(1),
                       .points = {part_of_pi(Rational(1, 2), 1)}};
    CHECK(contains(objection(what), "C = B = 0"));
    what.points = {point(Rational(1, 2), 1)};
    CHECK(contains(objection(what), "C = B = 0"));
    // With stride 2, pi/3 and 2 pi/3 are the same z, but not the same frequency.
    what = chain(3, {part_of_pi(Rational(1, 3), 1), part_of_pi(Rational(2, 3), 1)});
    what.stride = 2;
    CHECK(contains(objection(what), "C = B = 0"));
}

TEST_CASE("next to xi = 0, and a coefficient that is zero, and many rows") {
    Specification what = chain(2, {point(Rational(Integer(1), pow(Integer(10), 28)), 1)});
    CHECK(contains(objection(what), "to 1e-6"));
    what = chain(2, {point(Rational(1, 100000), 1)});
    const Table standard = derive(chain(2, {}));
    // O(xi^2) away, and a few roundings.
    CHECK(std::abs(c_of(derive(what), 1) - c_of(standard, 1)) < 1e-9);
    // n = 1, G = 9/2: omega^2/tan^2(xi/2) = (3/4 + 9/4) 3 = 9 at pi/3, a square.
    what = {.horizon = 1,
            .order = 2,
            .stabilisation = Rational(9, 2),
            .points = {part_of_pi(Rational(1, 3), 1)}};
    const Table zero = derive(what);
    CHECK(zero.digits == 40);
    CHECK(evaluate(zero.c[1], 0) == 0);
    // Thirty rows at one point: small differences of large numbers.
    what = {.horizon = 2,
            .order = 31,
            .stride = 2,
            .stabilisation = Rational(1),
            .points = {point(Rational(1, 5), 30)}};
    CHECK(derive(what).digits == 80);
}

TEST_CASE("the proof sees the 29th digit and a wave that goes out") {
    const Table table = derive(chain(2, {part_of_pi(Rational(1, 3), 1)}));
    Table wrong = table;
    // Along the rows at xi = 0, which stay exact.
    const Rational change(1, pow(Integer(10), 28));
    wrong.c[1] = reduce(constant(evaluate(table.c[1], 0) + 2 * change), constant(1));
    wrong.b[2] = reduce(constant(evaluate(table.b[2], 0) + change), constant(1));
    wrong.b[0] = reduce(constant(evaluate(table.b[0], 0) - change), constant(1));
    CHECK_THROWS_AS(prove(wrong), std::logic_error);
    // C = B = 0 at pi/3 absorbs nothing: NMBC1, matched at 2 pi/3 where b = 1, times 1 - z + z^2.
    wrong = derive(chain(3, {part_of_pi(Rational(1, 3), 1), part_of_pi(Rational(2, 3), 1)}));
    const auto set = [](std::vector<ExactFunction>& list, const std::vector<int>& values) {
        for (std::size_t j = 0; j < values.size(); ++j) {
            list[j] = reduce(constant(values[j]), constant(1));
        }
    };
    set(wrong.c, {1, 0, 0, 1});
    set(wrong.b, {-1, 2, -2, 1});
    wrong.specification.points[0].multiplicity = 2;  // rows at xi = 0 are too many for it
    CHECK_THROWS_WITH_AS(prove(wrong), doctest::Contains("C(z) is not zero"), std::logic_error);
    // What absorbs waves at pi/3 does not at 2 pi/3.
    wrong = table;
    wrong.specification.points = {part_of_pi(Rational(2, 3), 1)};
    CHECK_THROWS_AS(prove(wrong), std::logic_error);
    prove(table);
}
