// SPDX-License-Identifier: GPL-2.0-or-later
/// The rows of nmbcgen dispersion: every printed double against the printed formulas of Nicely 2018
/// in 100 digits, and what is known in closed form. Units dX = c = 1.
#include <doctest/doctest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "generator/commands/dispersion.hpp"

using nmbcgen::Rational;

namespace {

using Float = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_100::backend_type,
                                            boost::multiprecision::et_off>;

struct Row {
    std::string model;
    unsigned horizon;
    double G;
    double xi;
    double omega;
    double phase_velocity;
    double group_velocity;
};

/// The rows of one curve, and with_limit those of its limit after them.
std::vector<Row> rows_of(unsigned horizon, const Rational& G, unsigned samples,
                         bool with_limit = false) {
    nmbcgen::Curves curves;
    curves.horizons = {horizon};
    curves.samples = samples;
    curves.limit = with_limit;
    std::istringstream csv(nmbcgen::dispersion_rows(curves, 0, G));
    std::vector<Row> all;
    for (std::string line; std::getline(csv, line);) {
        std::istringstream fields(line);
        std::vector<std::string> texts;
        for (std::string text; std::getline(fields, text, ',');) {
            texts.push_back(text);
        }
        REQUIRE(texts.size() == 7);
        const auto number = [&](std::size_t i) { return std::strtod(texts[i].c_str(), nullptr); };
        all.push_back(
            {texts[0], unsigned(number(1)), number(2), number(3), number(4), number(5), number(6)});
    }
    return all;
}

/// (41).
Float lattice(unsigned n, const Float& G, const Float& xi) {
    Float S = 0;
    Float C = 0;
    for (unsigned m = 1; m <= n; ++m) {
        S += m * sin(xi * m);
        C += cos(xi * m) - 1;
    }
    const Float shape = Float(n) * (n + 1) * (2 * n + 1) / 3;
    return 2 * sqrt(pow(S / shape, 2) - G / pow(Float(n), 4) * (C + S * S / shape));
}

/// (42) with F, corrected as docs/evidence/errata.md has it, at delta = n.
Float limit(unsigned n, const Float& G, const Float& xi) {
    const Float delta = n;
    const Float d = delta * xi;
    const Float F = -2 * pow(d, 4) + 3 * pow(d * cos(d), 2) + 2 * pow(d, 3) * sin(d) +
                    3 * pow(sin(d), 2) - 3 * d * sin(2 * d);
    return sqrt(9 * pow(sin(d) - d * cos(d), 2) / pow(delta, 6) - 2 * G * F / pow(delta, 7)) /
           (xi * xi);
}

/// A central difference: step^2 omega'''/6 off, and 1e-57 by what is left of the 100 digits at the
/// smallest delta xi here.
template <class Function>
Float slope(const Function& omega, const Float& xi) {
    const Float step("1e-20");
    return (omega(xi + step) - omega(xi - step)) / (2 * step);
}

/// The nearest double: half a unit in the last place, 2^-53 = 1.11e-16. What is 0 exactly is so to
/// the accuracy of `slope`.
bool nearest(double printed, const Float& exact) {
    return abs(exact - printed) <= Float("1.111e-16") * abs(exact) + Float("1e-28");
}

Float exact(const Rational& value) {
    return Float(numerator(value)) / Float(denominator(value));
}

Float xi_of(std::size_t i, unsigned samples) {
    return boost::math::constants::pi<Float>() * i / samples;
}

template <class Function>
void check_row(const Row& row, const Function& omega, const Float& xi) {
    CAPTURE(row.model);
    CAPTURE(row.horizon);
    CAPTURE(row.G);
    CAPTURE(row.xi);
    CHECK(nearest(row.xi, xi));
    CHECK(nearest(row.omega, omega(xi)));
    CHECK(nearest(row.phase_velocity, omega(xi) / xi));
    CHECK(nearest(row.group_velocity, slope(omega, xi)));
}

}  // namespace

TEST_CASE("every number is the double nearest to (41), or to the corrected (42)") {
    constexpr unsigned samples = 36;
    for (const unsigned n : {1U, 2U, 3U, 7U}) {
        for (const Rational& G : {Rational(0), Rational(1, 1000), Rational(1, 2), Rational(5)}) {
            const std::vector<Row> all = rows_of(n, G, samples, true);
            REQUIRE(all.size() == 2 * samples);
            for (unsigned i = 1; i <= samples; ++i) {
                const Float xi = xi_of(i, samples);
                const Row& of_lattice = all[i - 1];
                const Row& of_limit = all[samples + i - 1];
                CHECK(of_lattice.model == "lattice");
                CHECK(of_limit.model == "limit");
                CHECK((of_lattice.horizon == n && of_limit.horizon == n));
                CHECK((Rational(of_lattice.G) == G || G == Rational(1, 1000)));
                if (G != 0 || i < samples) {  // there omega has a kink
                    check_row(
                        of_lattice, [&](const Float& x) { return lattice(n, exact(G), x); }, xi);
                }
                check_row(
                    of_limit, [&](const Float& x) { return limit(n, exact(G), x); }, xi);
            }
        }
    }
}

TEST_CASE("long waves, where (41) and (42) cancel, are as accurate") {
    // delta xi from 3e-4: of F, of order d^8/20, the terms of order d^2 leave 23 digits less.
    constexpr unsigned samples = 10'000;
    const std::vector<Row> all = rows_of(1, 1, samples, true);
    REQUIRE(all.size() == 2 * samples);
    for (unsigned i = 1; i <= samples; i = i < 20 ? i + 1 : 2 * i) {
        const Float xi = xi_of(i, samples);
        check_row(
            all[i - 1], [](const Float& x) { return lattice(1, 1, x); }, xi);
        check_row(
            all[samples + i - 1], [](const Float& x) { return limit(1, 1, x); }, xi);
    }
}

TEST_CASE("n = 1, G = 1/2 is the atom chain, omega = 2 sin(xi/2)") {
    constexpr unsigned samples = 50;
    const std::vector<Row> all = rows_of(1, Rational(1, 2), samples);
    REQUIRE(all.size() == samples);
    for (unsigned i = 1; i <= samples; ++i) {
        const Float half = xi_of(i, samples) / 2;
        CHECK(nearest(all[i - 1].omega, 2 * sin(half)));
        CHECK(nearest(all[i - 1].phase_velocity, sin(half) / half));
        CHECK(nearest(all[i - 1].group_velocity, cos(half)));
    }
    CHECK(all.back().omega == 2);
}

TEST_CASE("where omega vanishes at xi = pi, the group velocity is that below it, -3/(2n+1)") {
    // omega = 2 |S|/A_n with S'(pi) = sum (-1)^m m^2 = (-1)^n n(n+1)/2.
    for (const unsigned n : {1U, 2U, 3U, 8U, 99U}) {
        CAPTURE(n);
        const Row last = rows_of(n, 0, 1).back();
        CHECK(nearest(last.xi, boost::math::constants::pi<Float>()));
        CHECK(last.omega == 0);
        CHECK(last.phase_velocity == 0);
        CHECK(nearest(last.group_velocity, Float(-3) / (2 * n + 1)));
        // At any other G it is 0, however small.
        const Row stabilised = rows_of(n, Rational(1, 1'000'000), 1).back();
        CHECK(stabilised.omega > 0);
        CHECK(stabilised.group_velocity == 0);
    }
}

TEST_CASE("backward bands: none at n = 1 from G = 1/4 on, beyond xi = 1.823 at n = 2, G = 1") {
    constexpr unsigned samples = 1000;
    const auto backward = [&](unsigned n, const Rational& G) {
        std::vector<double> xi;
        for (const Row& row : rows_of(n, G, samples)) {
            if (row.group_velocity < 0) {
                xi.push_back(row.xi);
            }
        }
        return xi;
    };
    for (const Rational& G : {Rational(1, 4), Rational(1, 2), Rational(3)}) {
        CHECK(backward(1, G).empty());
    }
    // omega^2 = sin^2 + 2G(1-cos)^2 peaks at cos = -2G/(1-2G), for G < 1/4.
    CHECK(backward(1, Rational(1, 5)).front() ==
          doctest::Approx(std::acos(-2.0 / 3)).epsilon(2e-3));
    CHECK(backward(1, Rational(0)).size() == 500);  // from pi/2 to pi, less pi/2
    const std::vector<double> at_two = backward(2, 1);
    // The next sample from 1.823 on, itself rounded to three places.
    CHECK(at_two.front() > 1.8225);
    CHECK(at_two.front() < 1.8235 + 3.15 / samples);
    CHECK(rows_of(2, 1, samples).back().group_velocity == 0);
}

TEST_CASE("zero-energy modes are extrema at every G above 0, so n >= 2 has backward waves") {
    constexpr unsigned samples = 1000;
    // Zeros of S/sin(xi): 1 + 4x, and 12x^2 + 4x - 2, x = cos(xi).
    const std::vector<std::pair<unsigned, double>> modes{{2, std::acos(-1.0 / 4)},
                                                         {3, std::acos((-1 + std::sqrt(7)) / 6)},
                                                         {3, std::acos((-1 - std::sqrt(7)) / 6)}};
    for (const auto& [n, xi] : modes) {
        const auto below = std::size_t(xi / std::numbers::pi * samples) - 1;
        for (const Rational& G : {Rational(0), Rational(1, 10), Rational(1), Rational(20)}) {
            const std::vector<Row> all = rows_of(n, G, samples);
            CHECK((all[below].xi < xi && xi < all[below + 1].xi));
            CHECK(all[below].group_velocity * all[below + 1].group_velocity < 0);
            // At G = 0 it jumps from -v to v, v of order 1; elsewhere it passes 0.
            const double jump = all[below + 1].group_velocity - all[below].group_velocity;
            CHECK((G == 0 ? jump > 0.9 : std::abs(jump) < 0.1));
        }
    }
}

TEST_CASE("long waves are slower than c below G = 4 n^3/((n+1)(2n+1)) and faster above") {
    // omega^2 = xi^2 + xi^4 (G M4/(2n^4) - M4/(3 M2)) + .., M_k = sum m^k.
    for (const unsigned n : {1U, 2U, 3U, 5U}) {
        const Rational threshold(4 * n * n * n, (n + 1) * (2 * n + 1));
        CHECK(rows_of(n, threshold * Rational(99, 100), 1000).front().phase_velocity < 1);
        CHECK(rows_of(n, threshold * Rational(101, 100), 1000).front().phase_velocity > 1);
        // The limit: xi^2 + n^2 xi^4 (G/(2n) - 1)/5, that is from G = 2n on.
        CHECK(rows_of(n, Rational(2 * n) * Rational(99, 100), 1000, true)[1000].phase_velocity < 1);
        CHECK(rows_of(n, Rational(2 * n) * Rational(101, 100), 1000, true)[1000].phase_velocity >
              1);
    }
}

TEST_CASE("a family may state no limit") {
    CHECK_NOTHROW(nmbcgen::require_limit(nmbcgen::find_family("nopd1d")));
    CHECK_THROWS_WITH_AS(nmbcgen::require_limit({"short", nmbcgen::nopd1d}),
                         "the family short states no continuum limit", std::invalid_argument);
    CHECK_THROWS_AS(nmbcgen::find_family("short"), std::invalid_argument);
}

TEST_CASE("omega may vanish inside the band") {
    // n = 2, weights 1, 1/2, G = 0: S = sin xi + sin 2 xi is 0 at 2 pi/3, where A = 6 and
    // |d omega/d xi| = 2 |cos xi + 2 cos 2 xi|/6 = 1/2; below it omega falls.
    nmbcgen::Curves curves;
    curves.horizons = {2};
    curves.weights = {{Rational(1), Rational(1, 2)}};
    curves.samples = 3;
    std::istringstream csv(nmbcgen::dispersion_rows(curves, 0, 0));
    std::string line;
    std::getline(csv, line);
    std::getline(csv, line);
    CHECK(line == "lattice,2,0,2.0943951023931957,0,0,-0.5");
}
