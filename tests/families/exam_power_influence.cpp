// SPDX-License-Identifier: GPL-2.0-or-later
/// Seleson 2011, example 1: moments of (|xi| + eps)^-p, dispersion, and waves of chains with it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nmbc/chain.hpp>
#include <nmbc/ends.hpp>
#include <utility>
#include <vector>

#include "generator/exact/rational.hpp"
#include "generator/families/power_influence.hpp"

using namespace nmbcgen;

namespace {

/// delta = 5, eps = 1 and dX = 1/4 of the paper.
PowerInfluence of_paper(unsigned power) {
    return {power, 4, 20};
}

/// (a + b log) / c, c rational
void check_ratio(const WithLog& number, const WithLog& over, const Rational& factor,
                 const Rational& rational, const Rational& of_log) {
    REQUIRE(over.of_log == 0);
    CHECK(factor * number.rational / over.rational == rational);
    CHECK(factor * number.of_log / over.rational == of_log);
}

}  // namespace

TEST_CASE("the paper's table of 2/(n+1)! I(p, n)/I(p, 1), to its digits") {
    struct Row {
        unsigned power;
        double of_3, digit_3;
        double of_5, digit_5;
    };
    for (const Row& row :
         {Row{0, 1.042, 1e-3, 5.787e-1, 1e-4}, Row{3, 3.933e-1, 1e-4, 1.594e-1, 1e-4},
          Row{5, 1.225e-1, 1e-4, 3.126e-2, 1e-5}, Row{20, 1.838e-3, 1e-6, 5.836e-6, 1e-9},
          Row{100, 5.369e-5, 1e-8, 4.009e-9, 1e-12},
          Row{1000, 5.035e-7, 1e-10, 3.394e-13, 1e-16}}) {
        const PowerInfluence influence = of_paper(row.power);
        CAPTURE(row.power);
        CHECK(dispersion_coefficient(influence, 1) == doctest::Approx(1).epsilon(1e-14));
        CHECK(std::abs(dispersion_coefficient(influence, 3) - row.of_3) <= 0.51 * row.digit_3);
        CHECK(std::abs(dispersion_coefficient(influence, 5) - row.of_5) <= 0.51 * row.digit_5);
    }
}

TEST_CASE("closed forms, worked out with an algebra system") {
    const PowerInfluence three = of_paper(3);
    check_ratio(moment(three, 3), moment(three, 1), Rational(1, 12), Rational(101, 60),
                -Rational(18, 25));
    check_ratio(moment(three, 5), moment(three, 1), Rational(1, 360), Rational(109, 360),
                -Rational(2, 25));
    const PowerInfluence five = of_paper(5);
    check_ratio(moment(five, 3), moment(five, 1), Rational(1, 12), Rational(25, 204), 0);
}

TEST_CASE("p = 0 is Cin(k delta) = x^2/4 - x^4/96 + x^6/4320 - ..") {
    const PowerInfluence influence{0, 3, 7};
    const Rational delta(7, 3);
    check_ratio(moment(influence, 3), moment(influence, 1), Rational(1, 12), delta * delta / 24, 0);
    check_ratio(moment(influence, 5), moment(influence, 1), Rational(1, 360),
                delta * delta * delta * delta / 1080, 0);
}

TEST_CASE("eps to infinity: the coefficients become those of p = 0") {
    const PowerInfluence influence{3, 1'000'000'000, 5};
    constexpr double ratio = 5e-9;  // delta/eps; p times it is left out
    CHECK(dispersion_coefficient(influence, 3) ==
          doctest::Approx(ratio * ratio / 24).epsilon(3 * ratio).scale(0));
    CHECK(dispersion_coefficient(influence, 5) ==
          doctest::Approx(std::pow(ratio, 4) / 1080).epsilon(3 * ratio).scale(0));
}

TEST_CASE("delta to infinity: I(p, n) is the beta function B(n + 1, p - n - 1)") {
    // What lies beyond delta = 10^9 eps is below 10^-18 of it.
    const PowerInfluence influence{9, Rational(1, 10000000), 100};
    for (const unsigned n : {1U, 3U, 5U}) {
        const double beta = std::tgamma(n + 1) * std::tgamma(8 - n) / std::tgamma(9);
        CHECK(nearest_double(moment(influence, n).rational) ==
              doctest::Approx(beta).epsilon(1e-13));
    }
}

TEST_CASE("the continuum's factor makes another modulus on a lattice that does not resolve it") {
    CHECK(modulus_of_continuum_factor(of_paper(0)) == doctest::Approx(1).epsilon(1e-14));
    CHECK(std::abs(modulus_of_continuum_factor(of_paper(3)) - .985) < 5e-4);
    CHECK(std::abs(modulus_of_continuum_factor(of_paper(20)) - .26) < 5e-3);
    // On a fine one it does not.
    CHECK(modulus_of_continuum_factor({20, 100, 100}) > .99);
}

namespace {

/// A pulse exp(-((x - 500)/width)^2) at t = 220, in the chain with the paper's sizes: relative L2
/// distance from the two halves of d'Alembert's, in per cent. modulus: of the chain, over K.
double percent_off(unsigned power, double width, double modulus = 1) {
    constexpr double dX = 0.25;
    constexpr double end = 220;
    const double c = std::sqrt(1.8);
    const std::vector<Rational> weights = power_weights(of_paper(power));
    nmbc::Lattice lattice;
    lattice.symbol.resize(weights.size() + 1);
    double sum = 0;
    for (std::size_t k = 1; k <= weights.size(); ++k) {
        sum += double(k) * nearest_double(weights[k - 1]);
    }
    for (std::size_t k = 1; k <= weights.size(); ++k) {
        lattice.symbol[k] = -nearest_double(weights[k - 1]) / (double(k) * sum);
        lattice.symbol[0] -= 2 * lattice.symbol[k];
    }
    nmbc::Chain chain(lattice, nmbc::FreeEnd{},
                      {.nodes = 4000,
                       .spacing = dX,
                       .youngs_modulus = 1.8 * modulus,
                       .density = 1,
                       .time_step = 0.1});
    const auto pulse = [width](double x) { return std::exp(-(x / width) * (x / width)); };
    const auto place = [&](std::size_t entry) {
        return (double(entry - chain.first_interior()) + 0.5) * dX - 500;
    };
    std::vector<double> u(chain.nodes());
    for (std::size_t i = chain.ghosts(); i + chain.ghosts() < u.size(); ++i) {
        u[i] = pulse(place(i));
    }
    chain.start(u, std::vector<double>(u.size()));
    chain.advance(std::size_t(std::lround(end / 0.1)));
    double difference = 0;
    double size = 0;
    for (std::size_t i = chain.ghosts(); i + chain.ghosts() < u.size(); ++i) {
        const double local = (pulse(place(i) - c * end) + pulse(place(i) + c * end)) / 2;
        difference += std::pow(std::as_const(chain).displacement()[i] - local, 2);
        size += local * local;
    }
    return 100 * std::sqrt(difference / size);
}

}  // namespace

TEST_CASE("waves of the chain against the wave equation, by p and the width of the pulse") {
    struct Row {
        double width;
        double of_0, of_3, of_20;
    };
    // The digits that are given; p = 20 has the error of steps in it.
    for (const Row& row :
         {Row{5, 93.6, 72.7, 2.13}, Row{10, 43.0, 20.7, .266}, Row{20, 7.34, 2.82, .033}}) {
        CAPTURE(row.width);
        CHECK(percent_off(0, row.width) == doctest::Approx(row.of_0).epsilon(2e-3));
        CHECK(percent_off(3, row.width) == doctest::Approx(row.of_3).epsilon(2e-3));
        CHECK(percent_off(20, row.width) == doctest::Approx(row.of_20).epsilon(2e-2));
    }
    // The trap: with the continuum's factor p = 20 has about half of the speed.
    CHECK(std::abs(percent_off(20, 10, modulus_of_continuum_factor(of_paper(20))) - 141) < 1);
}
