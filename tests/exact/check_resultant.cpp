// SPDX-License-Identifier: GPL-2.0-or-later
/// Resultants and discriminants: textbook answers, Sylvester's determinant at single G, and the
/// identities they obey.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <stdexcept>

#include "generator/exact/rational_function.hpp"
#include "generator/exact/resultant.hpp"
#include "tests/support/generators.hpp"
#include "tests/support/known_roots.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

using Coefficients = std::vector<Polynomial>;

Coefficients product(const Coefficients& f, const Coefficients& g) {
    Coefficients result(f.size() + g.size());
    for (std::size_t i = 0; i < f.size(); ++i) {
        for (std::size_t j = 0; j < g.size(); ++j) {
            result[i + j] += f[i] * g[j];
        }
    }
    return result;
}

/// Of degree < size in w and < 3 in G, sometimes with zeros at the end, sometimes zero.
Coefficients random_in_w(std::size_t size) {
    Coefficients result;
    for (std::size_t k = 0; k < size; ++k) {
        result.push_back(*polynomial(3));
    }
    return result;
}

/// The last coefficient is not zero.
Coefficients random_of_degree(std::size_t degree) {
    Coefficients result = random_in_w(degree);
    result.push_back(*nonzero_polynomial(3));
    return result;
}

Coefficients random_nonzero(std::size_t size) {
    return random_of_degree(*rc::gen::inRange(std::size_t(0), size));
}

/// The determinant by Gaussian elimination over Q.
Rational determinant(std::vector<std::vector<Rational>> matrix) {
    Rational result = 1;
    for (std::size_t k = 0; k < matrix.size(); ++k) {
        std::size_t pivot = k;
        while (pivot < matrix.size() && matrix[pivot][k] == 0) {
            ++pivot;
        }
        if (pivot == matrix.size()) {
            return 0;
        }
        if (pivot != k) {
            std::swap(matrix[pivot], matrix[k]);
            result = -result;
        }
        result *= matrix[k][k];
        for (std::size_t i = k + 1; i < matrix.size(); ++i) {
            const Rational factor = matrix[i][k] / matrix[k][k];
            for (std::size_t j = k; j < matrix.size(); ++j) {
                matrix[i][j] -= factor * matrix[k][j];
            }
        }
    }
    return result;
}

/// Sylvester's determinant at one G, its size that of the polynomials in w: n rows of f, m of g.
Rational sylvester(const Coefficients& f, const Coefficients& g, const Rational& G) {
    const std::size_t m = f.size() - 1;
    const std::size_t n = g.size() - 1;
    std::vector<std::vector<Rational>> matrix(m + n, std::vector<Rational>(m + n));
    for (std::size_t row = 0; row < n; ++row) {
        for (std::size_t k = 0; k <= m; ++k) {
            matrix[row][row + k] = evaluate(f[m - k], G);
        }
    }
    for (std::size_t row = 0; row < m; ++row) {
        for (std::size_t k = 0; k <= n; ++k) {
            matrix[n + row][row + k] = evaluate(g[n - k], G);
        }
    }
    return determinant(matrix);
}

Polynomial sign(std::size_t exponent) {
    return constant(exponent % 2 == 0 ? 1 : -1);
}

}  // namespace

TEST_CASE("textbook resultants and discriminants") {
    const Polynomial G = poly({0, 1});
    const Polynomial one = constant(1);
    // At w = 1 the polynomial w^2 - G is 1 - G; res(f, w - 1) = (-1)^m f(1).
    CHECK(resultant({-G, {}, one}, {-one, one}) == one - G);
    CHECK(resultant({-one, one}, {-G, {}, one}) == one - G);
    // res(w - G, w + 2G) = G - (-2G)
    CHECK(resultant({-G, one}, {2 * G, one}) == 3 * G);
    // G w^2 + 3w + (1 + G): b^2 - 4ac
    CHECK(discriminant({one + G, constant(3), G}) == poly({9, -4, -4}));
    // w^3 + p w + q: -4p^3 - 27q^2 at p = G, q = 1 + G
    CHECK(discriminant({one + G, G, {}, one}) == poly({-27, -54, -27, -4}));
    CHECK(discriminant({G, poly({5})}) == one);
    // w^4 + G: 256 G^3
    CHECK(discriminant({G, {}, {}, {}, one}) == poly({0, 0, 0, 256}));
    // 0 is a root of the leading coefficient and of every other: no point of interpolation there.
    CHECK(resultant({G, G}, {G, {}, G}) == poly({0, 0, 0, 2}));
}

TEST_CASE("remainders may leave out degrees") {
    // Knuth's example, 4.6.1: degrees 8, 6, 4, 2, 1, 0.
    Coefficients f;
    Coefficients g;
    for (const int coefficient : {-5, 2, 8, -3, -3, 0, 1, 0, 1}) {
        f.push_back(constant(coefficient));
    }
    for (const int coefficient : {21, -9, -4, 0, 5, 0, 3}) {
        g.push_back(constant(coefficient));
    }
    CHECK(resultant(f, g) == constant(sylvester(f, g, 0)));
    CHECK(resultant(g, f) == constant(sylvester(g, f, 0)));
}

TEST_CASE("zero and constant polynomials") {
    const Polynomial G = poly({0, 1});
    const Coefficients quadratic{G, constant(1), constant(3)};
    CHECK(resultant({}, quadratic).is_zero());
    CHECK(resultant(quadratic, {{}, {}}).is_zero());
    CHECK(resultant({}, {}).is_zero());
    CHECK(resultant({G}, quadratic) == G * G);
    CHECK(resultant(quadratic, {constant(2), {}}) == constant(4));
    CHECK(resultant({G}, {constant(7)}) == constant(1));
    CHECK_THROWS_AS(discriminant({}), std::domain_error);
    CHECK_THROWS_AS(discriminant({G, {}}), std::domain_error);
}

TEST_CASE("the value at any G is Sylvester's determinant, where degrees fall, too") {
    CHECK(rc::check([] {
        const Coefficients f = random_nonzero(5);
        const Coefficients g = random_nonzero(5);
        const Polynomial result = resultant(f, g);
        for (const Rational& G : {*small_rational(), Rational(0), Rational(1)}) {
            RC_ASSERT(evaluate(result, G) == sylvester(f, g, G));
        }
    }));
}

TEST_CASE("zero where and only where there is a common factor") {
    CHECK(rc::check("a common factor", [] {
        const Coefficients common = random_of_degree(*rc::gen::inRange(std::size_t(1), 3UL));
        RC_ASSERT(
            resultant(product(random_in_w(4), common), product(random_in_w(4), common)).is_zero());
    }));
    CHECK(rc::check("prod (alpha_i - beta_k) over roots in Q[G]", [] {
        const auto alpha = *rc::gen::container<Coefficients>(3, polynomial(3));
        const auto beta = *rc::gen::container<Coefficients>(2, polynomial(3));
        Coefficients f{*nonzero_polynomial(2)};
        Coefficients g{*nonzero_polynomial(2)};
        Polynomial expected = f[0] * f[0] * g[0] * g[0] * g[0];
        for (const Polynomial& a : alpha) {
            f = product(f, {-a, constant(1)});
            for (const Polynomial& b : beta) {
                expected *= a - b;
            }
        }
        for (const Polynomial& b : beta) {
            g = product(g, {-b, constant(1)});
        }
        RC_ASSERT(resultant(f, g) == expected);
    }));
}

TEST_CASE("identities") {
    CHECK(rc::check("res(f g, h) = res(f, h) res(g, h)", [] {
        const Coefficients f = random_in_w(4);
        const Coefficients g = random_in_w(4);
        const Coefficients h = random_in_w(4);
        RC_ASSERT(resultant(product(f, g), h) == resultant(f, h) * resultant(g, h));
    }));
    CHECK(rc::check("res(g, f) = (-1)^(m n) res(f, g)", [] {
        const Coefficients f = random_nonzero(5);
        const Coefficients g = random_nonzero(5);
        RC_ASSERT(resultant(g, f) == resultant(f, g) * sign((f.size() - 1) * (g.size() - 1)));
    }));
    CHECK(rc::check("disc(f g) = disc(f) disc(g) res(f, g)^2", [] {
        const Coefficients f = random_of_degree(*rc::gen::inRange(1UL, 4UL));
        const Coefficients g = random_of_degree(*rc::gen::inRange(1UL, 4UL));
        const Polynomial mixed = resultant(f, g);
        RC_ASSERT(discriminant(product(f, g)) == discriminant(f) * discriminant(g) * mixed * mixed);
    }));
    CHECK(rc::check("a multiple factor makes the discriminant zero", [] {
        const Coefficients twice = random_of_degree(*rc::gen::inRange(1UL, 3UL));
        RC_ASSERT(discriminant(product(random_nonzero(3), product(twice, twice))).is_zero());
    }));
}
