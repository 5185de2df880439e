// SPDX-License-Identifier: GPL-2.0-or-later
/// The polynomial of boundary modes, and the roots of complex polynomials.
#include <complex>
#include <limits>

#include "generator/exact/rational_function.hpp"
#include "generator/stability/mode_polynomial.hpp"
#include "generator/stability/polynomial_roots.hpp"
#include "generator/stability/simultaneous_roots.hpp"
#include "tests/stability/boundary.hpp"

namespace {

using nmbcgen::evaluate;
using nmbcgen::Rational;
using nmbcgen::Table;
using Complex = std::complex<double>;

Rational power(const Rational& base, int exponent) {
    Rational product = 1;
    for (int i = 0; i < std::abs(exponent); ++i) {
        product *= base;
    }
    return exponent < 0 ? Rational(1 / product) : product;
}

/// symbol_0 + sum_m symbol_m (k^m + k^-m)
Rational at_wave(const std::vector<Rational>& symbol, const Rational& k) {
    Rational sum = symbol.empty() ? Rational(0) : symbol[0];
    for (std::size_t m = 1; m < symbol.size(); ++m) {
        sum += symbol[m] * (power(k, int(m)) + power(k, -int(m)));
    }
    return sum;
}

/// What mode_polynomial() is, as its header has it, from the table.
Rational written_out(const Table& table, const Rational& G, const Rational& dt, const Rational& y) {
    const Rational k = (1 + y) / (1 - y);
    std::vector<Rational> symbol;
    for (const auto& coefficient : table.model.symbol) {
        symbol.push_back(evaluate(coefficient, G));
    }
    const Rational omega_squared = at_wave(symbol, k);
    const Rational tau_sigma = at_wave(table.model.damping, k);
    const int stride = int(table.specification.stride);
    Rational C = 0;
    Rational B = 0;
    for (std::size_t j = 0; j < table.c.size(); ++j) {
        C += evaluate(table.c[j], G) * power(k, int(j) * stride);
        B += evaluate(table.b[j], G) * power(k, int(j) * stride);
    }
    const Rational left =
        B * B + tau_sigma * B * (C - B * dt / 2) + omega_squared * (C * C - B * B * dt * dt / 4);
    return left * power(1 - y * y, int(symbol.size()) - 1) *
           power(1 - y, 2 * stride * int(table.specification.order));
}

TEST_CASE("the polynomial of boundary modes is the interior's equation with sigma = B/C") {
    for (const Rational& damping : {Rational(0), Rational(1, 20)}) {
        for (const auto& [order, stride] : {std::pair(1U, 1U), std::pair(2U, 2U)}) {
            const Table table =
                nmbcgen::derive({"nopd1d", 2, order, stride, std::nullopt, damping});
            const Rational G(3, 7);
            for (const double dt : {0.0, 0.3, 1e-5, 2.5}) {
                CAPTURE(damping.convert_to<double>());
                CAPTURE(dt);
                const auto polynomial = nmbcgen::over_rationals(
                    mode_polynomial(stepped(make_half_space(table, G), dt)));
                Rational factor = 0;  // the same everywhere
                for (const Rational& y :
                     {Rational(-1, 3), Rational(-2, 5), Rational(1, 7), Rational(3)}) {
                    const Rational ratio =
                        evaluate(polynomial, damping == 0 ? Rational(y * y) : y) /
                        written_out(table, G, Rational(dt), y);
                    CHECK(ratio > 0);
                    CHECK((factor == 0 || ratio == factor));
                    factor = ratio;
                }
            }
        }
    }
}

/// prod (x - root), ascending.
std::vector<Complex> product(const std::vector<Complex>& roots) {
    std::vector<Complex> coefficients{1};
    for (const Complex root : roots) {
        coefficients.insert(coefficients.begin(), 0);
        for (std::size_t i = 0; i + 1 < coefficients.size(); ++i) {
            coefficients[i] -= root * coefficients[i + 1];
        }
    }
    return coefficients;
}

/// The distance of the nearest one, relative.
double distance_to(const Complex root, const std::vector<Complex>& found) {
    double least = std::numeric_limits<double>::infinity();
    for (const Complex one : found) {
        least = std::min(least, std::abs(one - root) / std::abs(root));
    }
    return least;
}

TEST_CASE("complex polynomials: roots of every size, and close ones") {
    using namespace std::complex_literals;
    const std::vector<std::vector<Complex>> cases{
        {2.0 + 1i},
        {1.0, -1.0, 1i, -1i},
        {1e-9, 1e-3i, 1.0 + 1i, -1e4, 1e9i},
        {0.3 + 0.1i, 0.30001 + 0.1i, -0.9 + 1e-3i, 1.1, -5.0, 7.0 - 2i, 1.0 + 1e-6i, 40i}};
    for (const std::vector<Complex>& roots : cases) {
        CAPTURE(roots.size());
        const auto found = nmbcgen::simultaneous_roots(product(roots));
        REQUIRE(found);
        CHECK(found->size() == roots.size());
        for (const Complex root : roots) {
            CAPTURE(root.real());
            // Two that are 1e-5 apart share the roundings of the coefficients, 1e-16/1e-5.
            CHECK(distance_to(root, *found) < 1e-9);
        }
    }
}

/// To half the digits, as for every method.
TEST_CASE("complex polynomials: double roots, with a root 0, of a leading coefficient 0, none") {
    using namespace std::complex_literals;
    const auto doubled = nmbcgen::polynomial_roots(product({1i, 1i, 2.0}));
    CHECK(doubled.size() == 3);
    CHECK(distance_to(1i, doubled) < 1e-7);
    CHECK(distance_to(2.0, doubled) < 1e-14);
    const auto with_zero = nmbcgen::polynomial_roots(std::vector<Complex>{0.0, -2i, 1.0, 0.0});
    REQUIRE(with_zero.size() == 2);
    CHECK(std::min(std::abs(with_zero[0]), std::abs(with_zero[1])) < 1e-15);
    CHECK(distance_to(2i, with_zero) < 1e-15);
    CHECK(nmbcgen::polynomial_roots(std::vector<Complex>{3.0}).empty());
    CHECK(nmbcgen::polynomial_roots(std::vector<Complex>{}).empty());
}

}  // namespace
