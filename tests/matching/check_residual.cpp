// SPDX-License-Identifier: GPL-2.0-or-later
/// The residual Delta(xi) of (46), evaluated at small wave numbers in 100 digits: it falls like
/// xi^(2N+1), and so does that of the damped lattice and in time steps. Neither Taylor coefficients
/// nor the symmetry of c and b are used.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"
#include "generator/pipeline.hpp"
#include "tests/support/generators.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;
using Float = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_100::backend_type,
                                            boost::multiprecision::et_off>;

namespace {

Float to_float(const Rational& value) {
    return Float(numerator(value).str()) / Float(denominator(value).str());
}

Float value_at(const ExactFunction& function, const Rational& G) {
    return to_float(evaluate(over_rationals(function.numerator), G) /
                    evaluate(over_rationals(function.denominator), G));
}

/// symbol[0] + sum 2 symbol[m] cos(m xi) at the given G; of symbol or damping.
template <class Coefficient>
Float cosine_sum(const std::vector<Coefficient>& symbol, const Rational& G, const Float& xi) {
    Float sum = 0;
    for (std::size_t m = 0; m < symbol.size(); ++m) {
        const Rational value = evaluate(Polynomial(symbol[m]), G);
        sum += to_float(value) * (m == 0 ? Float(1) : 2 * cos(Float(m) * xi));
    }
    return sum;
}

struct ComplexFloat {
    Float real;
    Float imaginary;
};

/// s = -decay + i omega, the root of s^2 + tau sigma s + omega_0^2 = 0 of a wave that comes in. In
/// leapfrog steps s = (2/dt) (zeta - 1)/(zeta + 1) with the factor of one step, the root of
///     zeta^2 - 2 p zeta + q = 0,   2 p = 2 - dt^2 omega_0^2 - dt tau sigma,  q = 1 - dt tau sigma.
ComplexFloat rate(const Table& table, const Rational& G, const Float& xi) {
    const Float decay = cosine_sum(table.model.damping, G, xi) / 2;
    const Float square = cosine_sum(table.model.symbol, G, xi);
    if (table.specification.time_step == 0) {
        return {-decay, sqrt(square - decay * decay)};
    }
    const Float dt = to_float(table.specification.time_step);
    const Float p = 1 - dt * dt * square / 2 - dt * decay;
    const Float q = 1 - 2 * dt * decay;
    const Float whole = dt / 2 * (q + 2 * p + 1);
    return {(q - 1) / whole, 2 * sqrt(q - p * p) / whole};
}

/// |s(xi) C(z) - B(z)|, z = exp(i stride xi).
Float residual(const Table& table, const Rational& G, const Float& xi) {
    const auto [growth, omega] = rate(table, G, xi);
    Float real = 0;
    Float imaginary = 0;
    for (std::size_t j = 0; j < table.c.size(); ++j) {
        const Float phase = Float(j * table.specification.stride) * xi;
        const Float c = value_at(table.c[j], G);
        const Float b = value_at(table.b[j], G);
        real += c * (growth * cos(phase) - omega * sin(phase)) - b * cos(phase);
        imaginary += c * (growth * sin(phase) + omega * cos(phase)) - b * sin(phase);
    }
    return sqrt(real * real + imaginary * imaginary);
}

/// d log |Delta| / d log xi, measured between xi and xi/2 at xi = 1e-5.
double slope(const Table& table, const Rational& G) {
    const Float xi = Float(1) / 100000;
    return static_cast<double>(log(residual(table, G, xi) / residual(table, G, xi / 2)) /
                               log(Float(2)));
}

/// |Delta| = k xi^p (1 + q xi^2 + ..), so that the measured slope differs from p by about
/// q xi^2 (3/4)/ln 2 = 1.1e-10 q. The bound allows |q| <= 1e7; a slope that is wrong is wrong by 1.
/// Rounding: Delta >= 1e-5^13 k or so, far above 1e-98.
constexpr double tolerance = 1e-3;

}  // namespace

TEST_CASE("the committed set at several G, stable ones among them") {
    const Rational G[]{Rational(1, 2), Rational(3, 4), Rational(19, 10), Rational(13, 4)};
    for (const Specification& what : committed_set()) {
        const Table table = derive(what);
        for (const Rational& value : G) {
            CAPTURE(what.horizon);
            CAPTURE(what.order);
            CAPTURE(to_string(value));
            CHECK(std::abs(slope(table, value) - (2 * what.order + 1)) < tolerance);
        }
    }
}

TEST_CASE("strides 2 and 3, and higher orders") {
    const Rational G(9, 7);
    for (const unsigned stride : {2U, 3U}) {
        for (const unsigned order : {1U, 2U, 3U, 5U, 6U}) {
            for (const unsigned horizon : {1U, 2U, 4U}) {
                const Table table = derive({.family = "nopd1d",
                                            .horizon = horizon,
                                            .order = order,
                                            .stride = stride,
                                            .stabilisation = {}});
                CAPTURE(horizon);
                CAPTURE(order);
                CAPTURE(stride);
                CHECK(std::abs(slope(table, G) - (2 * order + 1)) < tolerance);
            }
        }
    }
}

TEST_CASE("at G = 1, n = 1, NMBC1 gains an order: slope 5 instead of 3") {
    const Table table =
        derive({.family = "nopd1d", .horizon = 1, .order = 1, .stride = 1, .stabilisation = {}});
    CHECK(std::abs(slope(table, 1) - 5) < tolerance);
    CHECK(std::abs(slope(table, Rational(1, 2)) - 3) < tolerance);
}

TEST_CASE("damped or not, in time steps or not, at random G, horizons, orders and strides") {
    CHECK(rc::check("slope 2N + 1", [] {
        Specification what{.family = "nopd1d",
                           .horizon = *rc::gen::inRange(1U, 6U),
                           .order = *rc::gen::inRange(1U, 6U),
                           .stride = *rc::gen::inRange(1U, 4U),
                           .stabilisation = *positive_rational(),
                           .damping = *rc::gen::element(Rational(0), *positive_damping()),
                           .time_step = *rc::gen::element(Rational(0), *positive_damping())};
        try {
            const Table table = derive(what);
            const double measured = slope(table, *what.stabilisation);
            RC_LOG(std::to_string(measured));
            const double expected = 2 * what.order + 1;
            RC_ASSERT(measured > expected - tolerance);
            // More only where the condition gains an order, and then the next one does not exist.
            if (measured > expected + tolerance) {
                ++what.order;
                RC_ASSERT_THROWS_AS(derive(what), NoSuchBoundary);
            }
        } catch (const NoSuchBoundary&) {
            RC_DISCARD("no such boundary condition");
        }
    }));
}

TEST_CASE("damped lattices, functions of G") {
    for (const unsigned order : {2U, 3U, 4U}) {
        for (const unsigned horizon : {1U, 2U, 3U}) {
            CAPTURE(order);
            CAPTURE(horizon);
            Specification what{.family = "nopd1d",
                               .horizon = horizon,
                               .order = order,
                               .stride = horizon,
                               .stabilisation = {},
                               .damping = Rational(1, 10)};
            Table table = derive(what);
            for (const Rational& G : {Rational(0), Rational(9, 7)}) {
                CHECK(std::abs(slope(table, G) - (2 * order + 1)) < tolerance);
            }
            // The same coefficients on the lattice without damping, and the other way round, match
            // up to the power 3 of a_3 alone: a_4 differs.
            table.model.damping.clear();
            CHECK(std::abs(slope(table, Rational(9, 7)) - 4) < tolerance);
            what.damping = 0;
            Table undamped = derive(what);
            undamped.model = make_model("nopd1d", horizon, Rational(1, 10));
            CHECK(std::abs(slope(undamped, Rational(9, 7)) - 4) < tolerance);
        }
    }
}

TEST_CASE("the measurement sees an error of 1e-20 in one coefficient") {
    Table table = derive(
        {.family = "nopd1d", .horizon = 2, .order = 3, .stride = 1, .stabilisation = Rational(1)});
    const Rational nudge = Rational(Integer(1), pow(Integer(10), 20));
    const Rational first(table.b[0].numerator[0], table.b[0].denominator[0]);
    table.b[0] = to_rational_function(constant(first + nudge));
    CHECK(slope(table, 1) < 1);  // Delta(0) = -1e-20, above (1e-5)^7 = 1e-35
}
