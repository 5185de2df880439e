// SPDX-License-Identifier: GPL-2.0-or-later
/// The residual Delta(xi) of (46), evaluated at small wave numbers in 100 digits: it falls like
/// xi^(2N+1). Neither Taylor coefficients nor the symmetry of c and b are used.
#include <doctest/doctest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/pipeline.hpp"

using namespace nmbcgen;
using Float = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_100::backend_type,
                                            boost::multiprecision::et_off>;

namespace {

Float to_float(const Rational& value) {
    return Float(numerator(value).str()) / Float(denominator(value).str());
}

Float value_at(const RationalFunction& function, const Rational& G) {
    return to_float(evaluate(over_rationals(function.numerator), G) /
                    evaluate(over_rationals(function.denominator), G));
}

/// |i omega(xi) C(z) - B(z)| with z = exp(i s xi).
Float residual(const Table& table, const Rational& G, const Float& xi) {
    Float omega_squared = to_float(evaluate(table.model.symbol[0], G));
    for (std::size_t m = 1; m < table.model.symbol.size(); ++m) {
        omega_squared += 2 * to_float(evaluate(table.model.symbol[m], G)) * cos(Float(m) * xi);
    }
    const Float omega = sqrt(omega_squared);
    Float real = 0;
    Float imaginary = 0;
    for (std::size_t j = 0; j < table.c.size(); ++j) {
        const Float phase = Float(j * table.specification.stride) * xi;
        const Float c = value_at(table.c[j], G);
        const Float b = value_at(table.b[j], G);
        real += -omega * c * sin(phase) - b * cos(phase);
        imaginary += omega * c * cos(phase) - b * sin(phase);
    }
    return sqrt(real * real + imaginary * imaginary);
}

/// d log |Delta| / d log xi, measured between xi and xi/2 at xi = 1/1000.
double slope(const Table& table, const Rational& G) {
    const Float xi = Float(1) / 1000;
    return static_cast<double>(log(residual(table, G, xi) / residual(table, G, xi / 2)) /
                               log(Float(2)));
}

/// Delta = k xi^p (1 + q xi^2 + ..), so that the measured slope differs from p by about
/// q xi^2 (3/4)/ln 2 = 1.1e-6 q. The bound allows |q| <= 1e3; a slope that is wrong is wrong by 1.
/// Rounding: Delta >= 1e-3^15 or so, far above 1e-98.
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

TEST_CASE("the measurement sees an error of 1e-20 in one coefficient") {
    Table table = derive(
        {.family = "nopd1d", .horizon = 2, .order = 3, .stride = 1, .stabilisation = Rational(1)});
    const Rational nudge = Rational(Integer(1), pow(Integer(10), 20));
    const Rational first(table.b[0].numerator[0], table.b[0].denominator[0]);
    table.b[0] = to_rational_function(constant(first + nudge));
    CHECK(slope(table, 1) < 1);  // Delta(0) = -1e-20, above (1e-3)^7 = 1e-21
}
