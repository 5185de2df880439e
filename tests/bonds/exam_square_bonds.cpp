// SPDX-License-Identifier: GPL-2.0-or-later
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "generator/bonds/square_bonds.hpp"

using namespace nmbcgen;

namespace {

std::map<std::array<int, 2>, double> by_class(const SquareBonds& bonds) {
    std::map<std::array<int, 2>, double> alpha;
    for (std::size_t a = 0; a < bonds.classes.size(); ++a) {
        alpha[bonds.classes[a]] = bonds.alpha[a].value;
    }
    return alpha;
}

std::vector<Rational> in_thousandths(const std::vector<int>& alpha) {
    std::vector<Rational> exact;
    exact.reserve(alpha.size());
    for (const int value : alpha) {
        exact.emplace_back(value, 1000);
    }
    return exact;
}

double error_over_original(unsigned horizon, const SquareBonds& bonds) {
    const std::vector<Rational> ones(bonds.classes.size(), Rational(1));
    return figures_of(bonds).residual / figures_of(given_square_bonds(horizon, ones)).residual;
}

/// The squared difference of the dynamical matrices of the bonds and of the solid.
double difference(const SquareBonds& bonds, double k_x, double k_y) {
    double xx = -(0.4 * (k_x * k_x + k_y * k_y) + 0.8 * k_x * k_x);
    double yy = -(0.4 * (k_x * k_x + k_y * k_y) + 0.8 * k_y * k_y);
    double xy = -0.8 * k_x * k_y;
    for (std::size_t a = 0; a < bonds.classes.size(); ++a) {
        const auto [p, q] = bonds.classes[a];
        // (i, j), (-i, -j), (i, -j), (-i, j), each once; both orders of p = q are one.
        const double share = (p == q ? 0.5 : 1) * (q == 0 ? 0.5 : 1);
        for (const auto& [i, j] : {std::array{p, q}, std::array{q, p}}) {
            for (const int sign : {1, -1}) {
                const double stiffness =
                    2 * share * bonds.weights[a] * (1 - std::cos(k_x * i + sign * k_y * j));
                xx += stiffness * i * i;
                xy += stiffness * sign * i * j;
                yy += stiffness * j * j;
            }
        }
    }
    return xx * xx + 2 * xy * xy + yy * yy;
}

/// The mean over the zone, by a rule that is exact for its trigonometric part up to N = 5 and off
/// by the same for all sets otherwise.
double distance(const SquareBonds& bonds) {
    constexpr int steps = 64;
    double sum = 0;
    for (int x = 0; x < steps; ++x) {
        for (int y = 0; y < steps; ++y) {
            sum += difference(bonds, (x + 0.5) * std::numbers::pi / steps,
                              (y + 0.5) * std::numbers::pi / steps);
        }
    }
    return sum / (steps * steps);
}

}  // namespace

TEST_CASE("closed forms at N = 2, and numbers at N = 3") {
    const SquareBonds two = square_bonds(2, std::nullopt);
    std::vector<std::string> texts;
    for (const BondCoefficient& alpha : two.alpha) {
        REQUIRE(alpha.closed_form);
        texts.push_back(to_text(*alpha.closed_form));
    }
    CHECK(two.classes == std::vector<std::array<int, 2>>{{1, 0}, {1, 1}, {2, 0}});
    CHECK(texts == std::vector<std::string>{"68/105*pi + 16/105*pi^3", "1/3*sqrt(2)*pi",
                                            "1/105*pi - 8/105*pi^3"});
    const auto three = by_class(square_bonds(3, std::nullopt));
    const std::map<std::array<int, 2>, double> expected{{{2, 2}, 3.04206},  {{2, 1}, -6.07170},
                                                        {{1, 1}, 11.20239}, {{3, 0}, 4.69471},
                                                        {{2, 0}, -9.78683}, {{1, 0}, 22.33336}};
    for (const auto& [bond, alpha] : expected) {
        CHECK(std::abs(three.at(bond) - alpha) < 6e-6);  // digits
    }
}

TEST_CASE("long waves have the solid's speeds at every angle, steps and errors as listed") {
    struct Listed {
        unsigned horizon;
        double error;
        double largest_frequency;
    };
    for (const auto& [horizon, error, largest] :
         {Listed{2, .4624, 3.454}, Listed{3, .3437, 3.730}}) {
        const SquareBonds bonds = square_bonds(horizon, std::nullopt);
        CHECK(std::abs(error_over_original(horizon, bonds) - error) < 6e-5);
        CHECK(std::abs(figures_of(bonds).largest_frequency - largest) < 6e-4);
    }
    for (unsigned horizon = 2; horizon <= most_square_bonds; ++horizon) {
        const SquareFigures figures = figures_of(square_bonds(horizon, std::nullopt));
        for (const std::size_t angle : {0U, 1U}) {
            // Roundings of weights up to 100 times the speeds.
            CHECK(std::abs(figures.speed_P[angle] - 1) < 1e-13);
            CHECK(std::abs(figures.speed_S[angle] - 1) < 1e-13);
        }
    }
}

TEST_CASE("no other set with these speeds is nearer") {
    for (unsigned horizon = 2; horizon <= most_square_bonds; ++horizon) {
        const SquareBonds best = square_bonds(horizon, std::nullopt);
        const double least = distance(best);
        for (std::size_t a = 2; a < best.classes.size(); ++a) {
            for (const double change : {1e-4, -1e-4}) {
                SquareBonds other = best;
                other.weights[a] += change;
                // The sums of w i^4/2 and w i^2 j^2/2 over a class are kept by (1, 0) and (1, 1).
                const auto [i, j] = best.classes[a];
                const double count = i == j || j == 0 ? 4 : 8;
                const double fourth = count * (std::pow(i, 4) + std::pow(j, 4)) / 4;
                const double mixed = count * i * i * j * j / 2;
                other.weights[1] -= change * mixed / 2;
                other.weights[0] -= change * (fourth - mixed);
                CHECK(distance(other) > least);
            }
        }
    }
}

TEST_CASE("errors of phase velocities, worked out with another program") {
    // P and S at xi = 0.5, at worst: alpha = 1 at N = 3, then bz-ls at N = 2, 3, 4.
    const auto check = [](const SquareBonds& bonds, double P, double S) {
        const SquareFigures figures = figures_of(bonds);
        CHECK(std::abs(figures.speed_error[0][0] - P) < 6e-4);  // digits
        CHECK(std::abs(figures.speed_error[0][1] - S) < 6e-4);
    };
    check(given_square_bonds(3, std::vector<Rational>(6, Rational(1))), .034, .026);
    check(square_bonds(2, std::nullopt), .034, .028);
    check(square_bonds(3, std::nullopt), .020, .015);
    check(square_bonds(4, std::nullopt), .105, .080);
}

TEST_CASE("positive sets: at a vertex in closed form") {
    for (const Rational& bound : {Rational(0), Rational(1, 2)}) {
        const auto l = double(bound);
        const SquareBonds bonds = square_bonds(3, bound);
        const auto alpha = by_class(bonds);
        constexpr double pi = std::numbers::pi;
        constexpr double root = std::numbers::sqrt2;
        // One rounding of numbers up to 10.
        CHECK(
            alpha.at({1, 1}) ==
            doctest::Approx(9 * root * pi / 8 - l * (2 + 16 * std::sqrt(10) / 25)).epsilon(1e-15));
        CHECK(alpha.at({1, 0}) ==
              doctest::Approx(9 * pi / 4 - l * (5 + 18 * std::sqrt(5) / 25)).epsilon(1e-15));
        for (const std::array bond : {std::array{2, 0}, {2, 1}, {2, 2}, {3, 0}}) {
            CHECK(alpha.at(bond) == l);
        }
        CHECK(std::abs(error_over_original(3, bonds) - (bound == 0 ? .7225 : .8732)) < 6e-5);
    }
}

TEST_CASE("a bound below all coefficients changes nothing, one between them is kept") {
    const auto free = by_class(square_bonds(3, std::nullopt));
    const auto loose = by_class(square_bonds(3, Rational(-10)));
    for (const auto& [bond, alpha] : free) {
        CHECK(std::abs(loose.at(bond) - alpha) < 1e-14 * std::abs(alpha) + 1e-15);
    }
    for (unsigned horizon = 2; horizon <= most_square_bonds; ++horizon) {
        const SquareBonds bonds = square_bonds(horizon, Rational(1, 10));
        for (const BondCoefficient& alpha : bonds.alpha) {
            CHECK(alpha.value >= 0.1);
        }
        CHECK(figures_of(bonds).speed_S[1] == doctest::Approx(1).epsilon(1e-14));
    }
}

TEST_CASE("bounds that cannot be kept, sets of another size") {
    CHECK_THROWS_AS(square_bonds(3, Rational(3)), NoSuchBonds);
    CHECK_THROWS_AS(square_bonds(1, std::nullopt), std::invalid_argument);
    CHECK_THROWS_AS(square_bonds(most_square_bonds + 1, std::nullopt), std::invalid_argument);
    CHECK_THROWS_AS(given_square_bonds(2, {Rational(1)}), std::invalid_argument);
}

TEST_CASE("Table 2 of Alebrahim 2022, its sets evaluated") {
    struct Set {
        unsigned horizon;
        std::vector<int> alpha;  ///< thousandths, of (1, 0), (1, 1), (2, 0), (2, 1), (2, 2), (3, 0)
        double error;
        std::array<double, 2> P;
        std::array<double, 2> S;
        double largest_frequency;
    };
    const std::vector<Set> sets{
        {2, {1000, 1000, 1000}, 1, {1.086, .963}, {.822, 1.197}, 1.639},
        {2, {8300, 1400, -3100}, .481, {.992, .982}, {.972, 1.001}, 3.768},
        {2, {8200, 1600, -3100}, .473, {.998, 1.019}, {1.039, .977}, 3.776},
        {2, {8100, 2000, -3600}, .457, {.858, 1.022}, {1.162, .656}, 3.813},
        {2, {8500, 1600, -3200}, .482, {1.014, 1.027}, {1.039, 1.001}, 3.836},
        {3, {1000, 1000, 1000, 1000, 1000, 1000}, 1, {1.026, 1.014}, {1.003, 1.038}, 1.108},
        {3, {29600, 3100, -16800, 5100, -4200, 1000}, .411, {1.008, 1.005}, {1.002, 1.010}, 3.952},
        {3, {26600, 8500, -10200, -100, -1600, 300}, .403, {.997, 1.004}, {1.010, .991}, 3.847},
        {3,
         {25400, 13000, -24800, -100, -3800, 10500},
         .401,
         {1.010, 1.015},
         {1.020, 1.005},
         4.152},
        {3, {28700, 7600, -3700, 1400, -2800, -5500}, .481, {.994, .989}, {.983, .999}, 3.835},
        {3, {6900, 4900, 500, 500, 500, 500}, .701, {1.193, 1.185}, {1.176, 1.202}, 2.193},
    };
    for (const Set& set : sets) {
        const SquareBonds bonds = given_square_bonds(set.horizon, in_thousandths(set.alpha));
        const SquareFigures figures = figures_of(bonds);
        CHECK(std::abs(error_over_original(set.horizon, bonds) - set.error) < 1e-3);
        for (const std::size_t angle : {0U, 1U}) {
            CHECK(std::abs(figures.speed_P[angle] - set.P[angle]) < 1e-3);
            CHECK(std::abs(figures.speed_S[angle] - set.S[angle]) < 1e-3);
        }
        CHECK(std::abs(figures.largest_frequency - set.largest_frequency) < 1e-3);
    }
}

TEST_CASE("no set has a smaller error than the bound by linear programming") {
    CHECK(error_over_original(2, square_bonds(2, std::nullopt)) > .4613);
    CHECK(error_over_original(3, square_bonds(3, std::nullopt)) > .3272);
}
