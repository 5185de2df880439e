// SPDX-License-Identifier: GPL-2.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "generator/bonds/chain_bonds.hpp"

using namespace nmbcgen;

namespace {

constexpr std::array all_methods{BondMethod::point, BondMethod::subdomain, BondMethod::galerkin,
                                 BondMethod::least_squares, BondMethod::taylor};

std::vector<std::string> texts(BondMethod method, unsigned horizon) {
    std::vector<std::string> texts;
    for (const BondCoefficient& alpha : chain_bonds(method, horizon)) {
        texts.push_back(alpha.closed_form ? to_text(*alpha.closed_form) : "-");
    }
    return texts;
}

std::vector<double> values(BondMethod method, unsigned horizon) {
    std::vector<double> values;
    for (const BondCoefficient& alpha : chain_bonds(method, horizon)) {
        values.push_back(alpha.value);
    }
    return values;
}

double omega_squared(const std::vector<double>& alpha, double xi) {
    double sum = 0;
    for (std::size_t j = 1; j <= alpha.size(); ++j) {
        sum += 4 * alpha[j - 1] / (double(alpha.size() * alpha.size() * j)) *
               (1 - std::cos(double(j) * xi));
    }
    return sum;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("closed forms, worked out with an algebra system") {
    for (const BondMethod method : all_methods) {
        CHECK(texts(method, 1) == Texts{"1/2"});
    }
    CHECK(texts(BondMethod::point, 2) == Texts{"1/2*pi^2", "1 - 1/4*pi^2"});
    CHECK(texts(BondMethod::subdomain, 2) == Texts{"-2/3 + 4/9*pi^2", "4/3 - 2/9*pi^2"});
    CHECK(texts(BondMethod::galerkin, 2) == Texts{"6/5 + 4/15*pi^2", "2/5 - 2/15*pi^2"});
    CHECK(texts(BondMethod::least_squares, 2) == Texts{"58/35 + 8/35*pi^2", "6/35 - 4/35*pi^2"});
    CHECK(texts(BondMethod::taylor, 2) == Texts{"8/3", "-1/3"});
    CHECK(texts(BondMethod::point, 3) == Texts{"-9/16 + 9/8*pi^2", "-9/16*pi^2", "27/16"});
    CHECK(texts(BondMethod::subdomain, 3) == Texts{"3/8 - 1/4*pi^2 + 45/128*pi^3",
                                                   "-3 + 7/2*pi^2 - 9/8*pi^3",
                                                   "27/8 - 9/4*pi^2 + 81/128*pi^3"});
    CHECK(texts(BondMethod::galerkin, 3) ==
          Texts{"369/70 + 27/70*pi^2", "-837/70 + 27/35*pi^2", "54/7 - 9/14*pi^2"});
    CHECK(texts(BondMethod::least_squares, 3) ==
          Texts{"137/28 + 3/7*pi^2", "-125/14 + 3/7*pi^2", "163/28 - 3/7*pi^2"});
    CHECK(texts(BondMethod::taylor, 3) == Texts{"27/4", "-27/20", "3/20"});
}

TEST_CASE("alpha of Taylor series in closed form at every horizon") {
    for (unsigned N = 1; N <= most_chain_bonds; ++N) {
        const auto coefficients = chain_bonds(BondMethod::taylor, N);
        // N^2 (-1)^(j+1) (N!)^2/(j (N-j)! (N+j)!), from j = 1 on.
        Rational binomial(N, N + 1);
        for (unsigned j = 1; j <= N; ++j) {
            const Rational expected = Rational(int(N * N) * (j % 2 == 1 ? 1 : -1)) * binomial / j;
            REQUIRE(coefficients[j - 1].closed_form);
            CHECK(coefficients[j - 1].closed_form->front() == Quadratic(expected));
            binomial *= Rational(N - j, N + j + 1);
        }
    }
}

TEST_CASE("every set has long waves of speed 1, (34)") {
    for (const BondMethod method : all_methods) {
        for (unsigned N = 1; N <= most_chain_bonds; ++N) {
            const std::vector<double> alpha = values(method, N);
            double sum = 0;
            double size = 0;
            for (std::size_t j = 1; j <= N; ++j) {
                sum += double(j) * alpha[j - 1];
                size += std::abs(double(j) * alpha[j - 1]);
            }
            // Each value is one rounding off.
            CHECK(std::abs(sum - N * N / 2.0) <= 2.3e-16 * size);
        }
    }
}

TEST_CASE("the residual vanishes where the methods say, with and without a closed form") {
    constexpr double pi = std::numbers::pi;
    for (unsigned N = 2; N <= most_chain_bonds; ++N) {
        const unsigned parts = N - 1;
        const std::vector<double> at_points = values(BondMethod::point, N);
        const std::vector<double> of_parts = values(BondMethod::subdomain, N);
        const std::vector<double> galerkin = values(BondMethod::galerkin, N);
        // Roundings of some 1e3 in alpha's sums at N = 20.
        constexpr double roundings = 1e-12;
        for (unsigned m = 1; m <= parts; ++m) {
            const double xi = m * pi / parts;
            CHECK(std::abs(omega_squared(at_points, xi) - xi * xi) < roundings);
            double integral = -xi * xi * xi / 3;
            double weighted = 0;
            for (unsigned j = 1; j <= N; ++j) {
                const double factor = 4 / double(N * N * j);
                integral += factor * of_parts[j - 1] * (xi - std::sin(j * xi) / j);
                weighted += factor * galerkin[j - 1] * (j == m ? 1.5 : 1);
            }
            weighted -= pi * pi / 3 - 2 * (m % 2 == 0 ? 1 : -1) / double(m * m);
            CHECK(std::abs(integral) < roundings);
            CHECK(std::abs(weighted) < roundings);
        }
    }
}

TEST_CASE("no other set of long waves of speed 1 has a smaller mean square than least squares") {
    for (const unsigned N : {2U, 3U, 5U, 10U}) {
        const std::vector<double> best = values(BondMethod::least_squares, N);
        const auto mean_square = [](const std::vector<double>& alpha) {
            double sum = 0;
            constexpr int steps = 2000;
            for (int i = 0; i < steps; ++i) {
                const double xi = (i + 0.5) * std::numbers::pi / steps;
                sum += std::pow(omega_squared(alpha, xi) - xi * xi, 2) / steps;
            }
            return sum;
        };
        const double least = mean_square(best);
        for (std::size_t j = 1; j < N; ++j) {
            for (const double change : {1e-3, -1e-3}) {
                std::vector<double> other = best;
                other[j] += change;
                other[0] -= change * double(j + 1);  // keeps (34)
                CHECK(mean_square(other) > least);
            }
        }
    }
}

TEST_CASE("closed forms are there where they are promised") {
    for (unsigned N = 1; N <= most_chain_bonds; ++N) {
        const auto has = [N](BondMethod method) {
            return chain_bonds(method, N).front().closed_form.has_value();
        };
        CHECK(has(BondMethod::galerkin));
        CHECK(has(BondMethod::least_squares));
        CHECK(has(BondMethod::point) == (N <= 7));
        CHECK(has(BondMethod::subdomain) == (N <= 5 || N == 7));
    }
    // In Q[pi, sqrt(d)] the value is that of the equations in numbers: alpha_5 of point
    // collocation.
    CHECK(texts(BondMethod::point, 5).back().find("sqrt(2)") != std::string::npos);
}

TEST_CASE("Table 1 of Alebrahim 2022, but for its least squares") {
    using Column = std::vector<double>;
    const std::map<std::pair<BondMethod, unsigned>, Column> printed{
        {{BondMethod::point, 3}, {10.5, -5.5, 1.7}},
        {{BondMethod::point, 5}, {26.3, -15.4, 12.2, -7.7, 2.2}},
        {{BondMethod::point, 10}, {101, -52.1, 36.5, -29.5, 25.9, -24.3, 24.1, -22.1, 13.7, -3.7}},
        {{BondMethod::subdomain, 3}, {8.8, -3.3, 0.8}},
        {{BondMethod::subdomain, 5}, {25, -12.1, 6.8, -3.0, 0.7}},
        {{BondMethod::subdomain, 10}, {100, -50, 33.1, -24.5, 19.0, -14.7, 10.7, -6.5, 2.7, -0.5}},
        {{BondMethod::galerkin, 3}, {9.1, -4.3, 1.4}},
        {{BondMethod::galerkin, 5}, {25.0, -12.4, 8.4, -6.1, 2.3}},
    };
    for (const auto& [set, column] : printed) {
        const std::vector<double> alpha = values(set.first, set.second);
        for (std::size_t j = 0; j < column.size(); ++j) {
            // A digit behind the point, cut off in places; 101 and 100 have none.
            const double rounding = std::abs(column[j]) >= 100 ? 0.5 : 0.07;
            CHECK(std::abs(alpha[j] - column[j]) < rounding);
        }
    }
}

TEST_CASE("errors (49) over that of alpha = 1") {
    const std::map<BondMethod, std::vector<double>> expected{
        {BondMethod::taylor, {.422, .228, .124, .0600}},
        {BondMethod::point, {.487, .186, .0643, .0177}},
        {BondMethod::subdomain, {.200, .0855, .0312, .00795}},
        {BondMethod::least_squares, {.214, .0832, .0310, .00908}},
        {BondMethod::galerkin, {.206, .0783, .0284, .00812}},
    };
    constexpr std::array horizons{2U, 3U, 5U, 10U};
    for (const auto& [method, errors] : expected) {
        for (std::size_t i = 0; i < horizons.size(); ++i) {
            const double ratio = residual_of_chain(values(method, horizons[i])) /
                                 residual_of_chain(std::vector<double>(horizons[i], 1));
            CHECK(std::abs(ratio - errors[i]) < 5.1e-3 * errors[i]);  // three digits
        }
    }
}

TEST_CASE("bands") {
    const ChainBand chain = band_of_chain(std::vector<double>{0.5});
    CHECK(chain.largest_frequency == doctest::Approx(2).epsilon(1e-15));
    CHECK(chain.least_squared_speed ==
          doctest::Approx(4 / (std::numbers::pi * std::numbers::pi)).epsilon(1e-14));
    CHECK(band_of_chain(std::vector<double>{1, -3}).least_squared_speed < 0);
}

TEST_CASE("horizons that there are not") {
    CHECK_THROWS_AS(chain_bonds(BondMethod::point, 0), std::invalid_argument);
    CHECK_THROWS_AS(chain_bonds(BondMethod::point, most_chain_bonds + 1), std::invalid_argument);
}
