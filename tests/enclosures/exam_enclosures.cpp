// SPDX-License-Identifier: GPL-2.0-or-later
/// Intervals, zeros and divided differences hold what they must, and little more.
#include <doctest/doctest.h>

#include "generator/enclosures/interval.hpp"
#include "generator/enclosures/real_zeros.hpp"
#include "generator/enclosures/triangular.hpp"

namespace {

using nmbcgen::EnclosedPolynomial;
using nmbcgen::Interval;
using nmbcgen::Polynomial;
using nmbcgen::Rational;
using nmbcgen::Triangular;

/// Exactly.
bool holds(const Interval& interval, const Rational& value) {
    return Rational(interval.lower()) <= value && value <= Rational(interval.upper());
}

TEST_CASE("every operation rounds outwards, and keeps 0") {
    const Interval third = nmbcgen::enclose(Rational(1, 3));
    const Interval tenth = nmbcgen::enclose(Rational(1, 10));
    CHECK(holds(third, Rational(1, 3)));
    CHECK(holds(third + tenth, Rational(13, 30)));
    CHECK(holds(third - tenth, Rational(7, 30)));
    CHECK(holds(third * tenth, Rational(1, 30)));
    CHECK(holds(third / tenth, Rational(10, 3)));
    CHECK(holds(square(sqrt(third)), Rational(1, 3)));
    CHECK(width(third / tenth) < 1e-14);
    const Interval half = nmbcgen::enclose(Rational(1, 2));
    CHECK((half.lower() == 0.5 && half.upper() == 0.5));
    const Interval zero = Interval(0) * third + Interval(0);
    CHECK((zero.lower() == 0 && zero.upper() == 0));
    // smaller than any double, and not 0
    const Interval tiny = Interval(1e-200) * Interval(1e-200);
    CHECK((tiny.lower() < 0 && tiny.upper() > 0));
}

TEST_CASE("a polynomial of G over an interval") {
    // G^3 - G + 1/3 between 0 and 1/2: from 1/3 down to -1/24
    const std::vector<Polynomial> f{Polynomial(std::vector<Rational>{Rational(1, 3), -1, 0, 1})};
    const Interval range = nmbcgen::expand(f, 0, 0.5).enclosed().front();
    CHECK(holds(range, Rational(1, 3)));
    CHECK(holds(range, Rational(-1, 24)));
    CHECK(width(range) < 0.51);
}

TEST_CASE("what varies with G is enclosed together") {
    // G (1 - x) + x^2 at x = 1 is 1, whatever G is; enclosed coefficients give the width of G
    const std::vector<Polynomial> f{Polynomial(std::vector<Rational>{0, 1}),
                                    Polynomial(std::vector<Rational>{0, -1}),
                                    Polynomial(Rational(1))};
    const auto expansion = nmbcgen::expand(f, 1, 1.5);
    CHECK(width(expansion.at(Interval(1))) < 1e-14);
    CHECK(width(nmbcgen::value_at(expansion.enclosed(), Interval(1))) > 0.9);
    CHECK(width(Triangular::of(expansion, {1}).corner()) < 1e-14);
    // x^2 - x on [0.4, 0.6]: [0.4, 0.6] [-0.6, -0.4], or -0.25 + [-0.2, 0.2] [-0.1, 0.1]
    const auto parabola = nmbcgen::unexpanded({0, -1, 1});
    const Interval x(0.4, 0.6);
    CHECK(width(parabola.at(x)) > 0.19);
    const Interval values = nmbcgen::values_on(x, parabola, derivative(parabola).at(x));
    CHECK(holds(values, Rational(-1, 4)));
    CHECK(holds(values, Rational(-24, 100)));
    CHECK(width(values) < 0.04 + 1e-14);
}

TEST_CASE("zeros between -1 and 1 are found and counted") {
    // -x^2 + 1/4
    const auto two = nmbcgen::real_zeros(nmbcgen::unexpanded({0.25, 0, -1}));
    REQUIRE(two.has_value());
    REQUIRE(two->size() == 2);
    CHECK(holds(two->front().where, Rational(-1, 2)));
    CHECK(holds(two->back().where, Rational(1, 2)));
    CHECK(two->front().counts == std::vector{1});
    CHECK(width(two->back().where) < 1e-14);
    // -x^2 + [-e, e]: none or two at 0
    const auto pair = nmbcgen::real_zeros(nmbcgen::unexpanded({Interval(-1e-6, 1e-6), 0, -1}));
    REQUIRE(pair.has_value());
    REQUIRE(pair->size() == 1);
    CHECK(pair->front().counts == std::vector{0, 2});
    CHECK(pair->front().where.lower() <= -1e-3);
    CHECK(pair->front().where.upper() >= 1e-3);
    // -x^2 + 1e-4 + [-e, e]: 0.01 to within 5e-5, of which no eighth can be cut off
    const auto near = nmbcgen::real_zeros(nmbcgen::unexpanded({Interval(0.99e-4, 1.01e-4), 0, -1}));
    REQUIRE(near.has_value());
    REQUIRE(near->size() == 2);
    CHECK(near->back().where.lower() <= std::sqrt(0.99e-4));
    CHECK(near->back().where.upper() >= std::sqrt(1.01e-4));
    CHECK(width(near->back().where) < 4.0 / 3 * (std::sqrt(1.01e-4) - std::sqrt(0.99e-4)));
    // -x^3 + [-e, e]: one or three
    CHECK(!nmbcgen::real_zeros(nmbcgen::unexpanded({Interval(-1e-6, 1e-6), 0, 0, -1})).has_value());
    CHECK(nmbcgen::real_zeros(nmbcgen::unexpanded({-1}))->empty());
}

TEST_CASE("divided differences, of points that meet, too") {
    const EnclosedPolynomial cube{0, 0, 0, 1};
    // f[a, b, c] = a + b + c
    CHECK(holds(Triangular::of(cube, {0.5, 0.25, -1}).corner(), Rational(-1, 4)));
    CHECK(holds(Triangular::of(cube, {0.5, 0.5, -1}).corner(), 0));
    // f''/2 = 3 x
    CHECK(holds(Triangular::of(cube, {0.5, 0.5, 0.5}).corner(), Rational(3, 2)));
    // of a polynomial of less than the degree exactly 0
    const Interval none = Triangular::of({1, 2}, {0.1, 0.2, 0.3}).corner();
    CHECK((none.lower() == 0 && none.upper() == 0));
    // (1/x)[a, b] = -1/(a b)
    const auto inverse = Triangular::of({0, 1}, {0.5, 0.25}).inverse();
    REQUIRE(inverse.has_value());
    CHECK(holds(inverse->corner(), -8));
    CHECK(!Triangular::of({0, 1}, {0.5, 0}).inverse().has_value());
}

TEST_CASE("positive semidefinite") {
    CHECK(nmbcgen::is_positive({{2, 0}, {1, 1}}));
    CHECK(!nmbcgen::is_positive({{1, 0}, {2, 1}}));
    CHECK(nmbcgen::is_positive({{0, 0}, {0, 1}}));
    CHECK(!nmbcgen::is_positive({{0, 0}, {1, 1}}));
    CHECK(!nmbcgen::is_positive({{Interval(-1e-9, 1)}}));
}

}  // namespace
