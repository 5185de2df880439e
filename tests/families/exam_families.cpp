// SPDX-License-Identifier: GPL-2.0-or-later
/// Influence functions, bond-based lattices and the chain of atoms, against formulas by hand.
#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <stdexcept>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"
#include "generator/families/influence.hpp"

using namespace nmbcgen;

namespace {

using Weights = std::vector<Rational>;

double omega_squared(const Model& model, double G, double xi) {
    double sum = 0;
    for (std::size_t m = 0; m < model.symbol.size(); ++m) {
        const double coefficient = nearest_double(evaluate(model.symbol[m], Rational(G)));
        sum += (m == 0 ? 1 : 2) * coefficient * std::cos(double(m) * xi);
    }
    return sum;
}

/// (16), (34) with bonds weighted: the strain's and each bond's share of omega^2 as |.|^2 of what
/// a wave exp(i xi I) makes of it.
double nopd_by_hand(const Weights& weights, double G, double xi) {
    const std::complex<double> i(0, 1);
    const auto n = double(weights.size());
    double shape = 0;
    double influence = 0;
    std::complex<double> strain = 0;
    for (std::size_t k = 0; k < weights.size(); ++k) {
        const double w = nearest_double(weights[k]);
        const auto j = double(k + 1);
        shape += 2 * w * j * j;
        influence += 2 * w;
        strain += w * j * 2.0 * i * std::sin(j * xi);
    }
    strain /= shape;
    double total = std::norm(strain);
    for (std::size_t k = 0; k < weights.size(); ++k) {
        for (const double j : {double(k + 1), -double(k + 1)}) {
            const std::complex<double> state = std::exp(i * j * xi) - 1.0 - j * strain;
            total +=
                G * 2 / std::pow(n, 3) * nearest_double(weights[k]) / influence * std::norm(state);
        }
    }
    return total;
}

/// c^2, half the second derivative of omega^2 at xi = 0.
Rational speed_squared(const Model& model, const Rational& G) {
    Rational sum = 0;
    for (std::size_t m = 1; m < model.symbol.size(); ++m) {
        sum -= Rational(m * m) * evaluate(model.symbol[m], G);
    }
    return sum;
}

}  // namespace

TEST_CASE("influence functions of nopd1d") {
    for (const Weights& weights :
         {Weights{1, Rational(1, 2)}, Weights{1, 3}, Weights{3, 2, 1}, Weights{1, 1, 7, 2}}) {
        const Model model = make_model("nopd1d", unsigned(weights.size()), 0, weights);
        CHECK(model.symbol.size() == 2 * weights.size() + 1);
        for (const double G : {0.0, 0.5, 3.0}) {
            CHECK(speed_squared(model, Rational(G)) == 1);
            for (const double xi : {0.1, 1.0, 2.5, 3.14}) {
                // Sums of less than 30 numbers of size 1 + G.
                CHECK(std::abs(omega_squared(model, G, xi) - nopd_by_hand(weights, G, xi)) <
                      1e-14 * (1 + G));
            }
        }
    }
}

TEST_CASE("of a common factor nothing is seen, and constant influence is the usual one") {
    const Weights weights{2, 1, 3};
    const Weights tenfold{20, 10, 30};
    const Weights constant(3, Rational(7));
    CHECK(make_model("nopd1d", 3, 0, weights).symbol == make_model("nopd1d", 3, 0, tenfold).symbol);
    CHECK(make_model("nopd1d", 3, 0, constant).symbol == make_model("nopd1d", 3).symbol);
    CHECK(make_model("nopd1d", 3, 0, constant).description == make_model("nopd1d", 3).description);
    CHECK(make_model("nopd1d", 3, 0, weights).description.ends_with(", influence 2, 1, 3"));
    CHECK(normalised(weights) == Weights{1, Rational(1, 2), Rational(3, 2)});
    CHECK(normalised(constant).empty());
}

TEST_CASE("named influence functions") {
    REQUIRE(influences().front().name == "constant");
    for (const Influence& influence : influences()) {
        CAPTURE(influence.name);
        for (const unsigned n : {1U, 2U, 9U}) {
            const Weights weights = weights_of(influence, n);
            REQUIRE(weights.size() == n);
            for (std::size_t k = 0; k < n; ++k) {
                CHECK(weights[k] > 0);
                CHECK((k == 0 || weights[k] <= weights[k - 1]));
            }
        }
    }
    CHECK(weights_of(influences()[1], 3) ==
          Weights{Rational(3, 4), Rational(1, 2), Rational(1, 4)});
    CHECK(weights_of(influences()[2], 3) == Weights{1, Rational(1, 2), Rational(1, 3)});
    CHECK(weights_of(influences()[3], 2) == Weights{Rational(20, 27), Rational(7, 27)});
}

TEST_CASE("bond1d: springs w_m/m, c = 1, no further than the horizon") {
    // k (1, 1/2) with k (1 + 2) = 1: omega^2 = (2/3)(1 - cos xi) + (1/3)(1 - cos 2 xi).
    const Model two = make_model("bond1d", 2);
    CHECK(two.symbol == std::vector<Polynomial>{constant(1), constant(Rational(-1, 3)),
                                                constant(Rational(-1, 6))});
    for (const Weights& weights : {Weights{1, 2, 3}, Weights{5, 1, 1, Rational(1, 9)}}) {
        const Model model = make_model("bond1d", unsigned(weights.size()), 0, weights);
        CHECK(model.symbol.size() == weights.size() + 1);
        CHECK(speed_squared(model, 0) == 1);
        for (std::size_t m = 2; m < model.symbol.size(); ++m) {
            CHECK(evaluate(model.symbol[m], 0) * Rational(m) * weights[0] ==
                  evaluate(model.symbol[1], 0) * weights[m - 1]);
        }
        CHECK_FALSE(has_stabilisation(model));
    }
}

TEST_CASE("chain1d: 2 sin(xi/2), as bond1d and nopd1d with G = 1/2 at horizon 1") {
    const Model chain = make_model("chain1d", 1);
    CHECK(chain.symbol == std::vector<Polynomial>{constant(2), constant(-1)});
    CHECK(chain.symbol == make_model("bond1d", 1).symbol);
    const Model nopd = make_model("nopd1d", 1);
    for (std::size_t m = 0; m < nopd.symbol.size(); ++m) {
        CHECK(evaluate(nopd.symbol[m], Rational(1, 2)) ==
              (m < chain.symbol.size() ? evaluate(chain.symbol[m], 0) : Rational(0)));
    }
}

TEST_CASE("models that do not exist") {
    CHECK_THROWS_AS(make_model("chain1d", 2), NoSuchModel);
    CHECK_THROWS_AS(make_model("bond1d", 2, Rational(1, 10)), NoSuchModel);
    const Weights weights{1, 2};
    CHECK_THROWS_AS(make_model("nopd1d", 3, 0, weights), NoSuchModel);
    for (const Rational& wrong : {Rational(0), Rational(-1)}) {
        const Weights bad{1, wrong};
        CHECK_THROWS_AS(make_model("bond1d", 2, 0, bad), NoSuchModel);
    }
}
