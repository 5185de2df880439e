// SPDX-License-Identifier: GPL-2.0-or-later
/// The threshold and the greatest frequency of nopd1d, exactly, against the formulas of
/// docs/reference/closed-forms.md, which hold for all horizons and are here written out at some.
#include <doctest/doctest.h>

#include <stdexcept>

#include "generator/exact/algebraic_number.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/exact/real_roots.hpp"
#include "generator/families/family.hpp"
#include "generator/lattice/band.hpp"
#include "generator/lattice/band_structure.hpp"

using namespace nmbcgen;

namespace {

constexpr unsigned horizons = 6;

BandStructure structure(unsigned n) {
    return band_structure(make_model("nopd1d", n), n);
}

/// sum over m of weight(m) cos(m xi) as a polynomial in x = cos xi.
template <class Weight>
Polynomial cosines(unsigned n, Weight weight) {
    std::vector<Polynomial> symbol{Polynomial()};
    for (unsigned m = 1; m <= n; ++m) {
        symbol.push_back(constant(Rational(weight(m)) / 2));
    }
    std::vector<Rational> coefficients;
    for (const Polynomial& coefficient : band(symbol)) {
        coefficients.push_back(evaluate(coefficient, 0));
    }
    return Polynomial(std::move(coefficients));
}

bool reaches_zero(const Polynomial& in_x) {
    return count_real_roots(in_x, -1, 1) > 0;
}

/// omega^2(x) - level at one G.
Polynomial above(unsigned n, const Rational& G, const Rational& level) {
    std::vector<Rational> coefficients;
    for (const Polynomial& coefficient : band(make_model("nopd1d", n).symbol)) {
        coefficients.push_back(evaluate(coefficient, G));
    }
    return Polynomial(std::move(coefficients)) - constant(level);
}

struct Bounds {
    Rational low;
    Rational high;
};

/// Of factor * number: 1e-12 * factor apart, the number between them.
Bounds narrow(AlgebraicNumber number, const Rational& factor = 1) {
    const Rational width(Integer(1), Integer(1000000000000));
    if (is_rational(number)) {
        return {(number.low - width / 2) * factor, (number.high + width / 2) * factor};
    }
    refine(number, width);
    return {number.low * factor, number.high * factor};
}

/// Whether the maximum of omega^2 at this G is between the bounds.
bool is_highest(const Bounds& squared, unsigned n, const Rational& G) {
    return reaches_zero(above(n, G, squared.low)) && !reaches_zero(above(n, G, squared.high));
}

/// The largest root W of BandStructure::below at a G.
AlgebraicNumber largest_root(const BandStructure& band, const Rational& G) {
    std::vector<Rational> coefficients;
    for (const Polynomial& coefficient : band.below) {
        coefficients.push_back(evaluate(coefficient, G));
    }
    return real_roots(Polynomial(std::move(coefficients)), 0).back();
}

}  // namespace

TEST_CASE("known thresholds") {
    CHECK(to_text(structure(1).threshold) == "1/4");
    CHECK(to_text(structure(2).threshold) == "1032/1445");
    CHECK(to_text(structure(3).threshold) == "(-282042 + 29079*sqrt(718))/393764");
    // 1.846148 of tests/stability/exam_windows.cpp, half a unit of its last digit.
    CHECK(nearest_double(structure(4).threshold) == doctest::Approx(1.846148).epsilon(3e-7));
    CHECK(to_text(structure(1).slope) == "8");
    CHECK(to_text(structure(2).slope) == "25/32");
    CHECK(to_text(structure(3).slope) == "(392 + 28*sqrt(7))/2187");
}

TEST_CASE("G* = (n^4/A) mu/(1+mu), -mu the least value of sum m^2 cos(m xi) / sum m^2") {
    for (unsigned n = 1; n <= horizons; ++n) {
        CAPTURE(n);
        const Rational sum(Integer(n * (n + 1) * (2 * n + 1)),
                           Integer(6));  // of m^2; A is twice it
        const Polynomial sigma = cosines(n, [](unsigned m) { return m * m; }) / constant(sum);
        const Bounds threshold = narrow(structure(n).threshold);
        const auto reached_by = [&](const Rational& G) {
            const Rational g = G * 2 * sum / (n * n * n * n);
            return reaches_zero(sigma + constant(g / (1 - g)));
        };
        CHECK(reached_by(threshold.low));
        CHECK_FALSE(reached_by(threshold.high));
    }
}

TEST_CASE("K = 4 kappa/n^4, kappa the greatest value of sum 1 - cos(m xi)") {
    for (unsigned n = 1; n <= horizons; ++n) {
        CAPTURE(n);
        const Polynomial C = cosines(n, [](unsigned) { return 1; }) - constant(n);
        const Bounds kappa = narrow(structure(n).slope, Rational(n * n * n * n, 4));
        CHECK(reaches_zero(C + constant(kappa.low)));
        CHECK_FALSE(reaches_zero(C + constant(kappa.high)));
    }
}

TEST_CASE("omega_max^2 = K G from G* on, and not much below") {
    for (unsigned n = 1; n <= horizons; ++n) {
        const BandStructure band = structure(n);
        const Rational first = narrow(band.threshold).high;
        for (const Rational& G : {first, first * 2, first * 1000}) {
            CAPTURE(n);
            CHECK(is_highest(narrow(band.slope, G), n, G));
        }
        CHECK_FALSE(is_highest(narrow(band.slope, first / 2), n, first / 2));
    }
}

TEST_CASE("n = 1 and 2: omega_max^2 below G*") {
    for (const unsigned n : {1U, 2U}) {
        const BandStructure band = structure(n);
        REQUIRE(band.below.size() == n + 1);
        for (const int part : {0, 1, 10, 50, 90}) {
            const Rational G = band.threshold.low * part / 100;
            CAPTURE(n);
            CAPTURE(part);
            CHECK(is_highest(narrow(largest_root(band, G)), n, G));
        }
    }
    // n = 1: W = 1/(1 - 2G), and 8G from 1/4 on.
    CHECK(to_text(largest_root(structure(1), Rational(1, 10))) == "5/4");
    CHECK(to_text(largest_root(structure(1), Rational(1, 4))) == "2");
    // n = 2: the two branches meet at 32/45, before G* = 1032/1445.
    const Rational meeting(32, 45);
    const Rational just_below = meeting - Rational(1, 1000);
    const Rational just_above = meeting + Rational(1, 1000);
    const BandStructure two = structure(2);
    CHECK(std::is_gt(compare(two.threshold, just_above)));
    CHECK(to_text(largest_root(two, meeting)) == "5/9");
    CHECK(is_highest(narrow(largest_root(two, just_below)), 2, just_below));
    CHECK_FALSE(is_highest(narrow(two.slope, just_below), 2, just_below));
    CHECK(is_highest(narrow(two.slope, just_above), 2, just_above));
    for (unsigned n = 3; n <= horizons; ++n) {
        CHECK(structure(n).below.empty());
    }
}

TEST_CASE("bands of another kind are refused") {
    const Polynomial G(std::vector<Rational>{0, 1});
    const auto refused = [](std::vector<Polynomial> symbol) {
        Model model = make_model("nopd1d", 1);
        model.symbol = std::move(symbol);
        CHECK_THROWS_AS(band_structure(model, 1), std::domain_error);
    };
    refused({constant(2), constant(-1)});          // without G
    refused({G * constant(2), G * constant(-1)});  // nothing else
    refused({constant(2), constant(-1), G});       // omega^2 > 0 at xi = pi and G = 0
    refused({constant(Rational(1, 2)), Polynomial(), constant(Rational(-1, 4)) + G * G});
    // 1 - x^2 + G (1-x)(1-x^2): a maximum that stays near x = -1/3, but moves.
    refused({constant(Rational(1, 2)) + G * constant(Rational(1, 2)), G * constant(Rational(-1, 8)),
             constant(Rational(-1, 4)) + G * constant(Rational(-1, 4)),
             G * constant(Rational(1, 8))});
}
