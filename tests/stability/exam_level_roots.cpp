// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "generator/stability/level_roots.hpp"
#include "generator/stability/polynomial_roots.hpp"

namespace {

using Complex = std::complex<double>;

/// scale prod (x - root), whose complex roots come in pairs.
std::vector<double> polynomial_with(const std::vector<Complex>& roots, double scale = 1) {
    std::vector<Complex> product{scale};
    for (const Complex root : roots) {
        product.insert(product.begin(), 0.0);
        for (std::size_t i = 0; i + 1 < product.size(); ++i) {
            product[i] -= root * product[i + 1];
        }
    }
    std::vector<double> real(product.size());
    std::ranges::transform(product, real.begin(), [](Complex c) { return c.real(); });
    return real;
}

/// p + shift is given, so that p has the value `shift` at these roots.
void check_roots(const std::vector<Complex>& roots, double shift, double error, double scale = 1) {
    std::vector<double> p = polynomial_with(roots, scale);
    p[0] += shift;
    const auto found = nmbcgen::LevelRoots(p).at(shift);
    REQUIRE(found.size() == roots.size());
    for (const Complex root : roots) {
        CAPTURE(root);
        const auto distance = [root](Complex x) { return std::abs(x - root); };
        const Complex nearest = *std::ranges::min_element(found, {}, distance);
        CHECK(distance(nearest) <= error * std::max(1.0, std::abs(root)));
        CHECK((nearest.imag() == 0) == (root.imag() == 0));
    }
}

}  // namespace

TEST_CASE("roots of a real polynomial at a level, real ones without an imaginary part") {
    using namespace std::complex_literals;
    // Roots are well apart: some hundred roundings of their sizes. It is ten times as much where
    // there are more of them, or p is a difference of larger terms.
    constexpr double error = 1e-13;
    for (const double shift : {0.0, 0.25, -3.0}) {
        check_roots({0.5}, shift, error);
        check_roots({-0.25, 0.75}, shift, error);
        check_roots({0.5 + 2i, 0.5 - 2i}, shift, error);
        check_roots({0.5, 1i, -1i}, shift, error);           // monotone
        check_roots({-1e3, 1i, -1i}, shift, 1e-10);          // p is 1e3 where they are
        check_roots({-0.5, 0.25, 4.0, -7.0}, shift, 1e-12);  // p' is small beside p's terms
        check_roots({-0.5, 0.25, 1.0 + 1i, 1.0 - 1i}, shift, error);
        check_roots({-0.5, 0.25, 1.0 + 1i, 1.0 - 1i, -2.0 + 0.5i, -2.0 - 0.5i}, shift, 1e-12);
        check_roots({-0.5, 0.25, 0.75, 1.5, 3.0 + 1i, 3.0 - 1i}, shift, 1e-12);
    }
    CHECK(nmbcgen::LevelRoots({}).at(1).empty());
    CHECK(nmbcgen::LevelRoots({2.0, 0.0}).at(1).empty());
}

TEST_CASE("a level through an extremum has a double root there") {
    // x^2 (x^2 - 2) at its minima, in numbers without roundings, and at its maximum
    const nmbcgen::LevelRoots square({0, 0, -2, 0, 1});
    for (const auto& [y, doubled] : {std::pair(-1.0, 1.0), std::pair(0.0, 0.0)}) {
        const auto roots = square.at(y);
        CHECK(std::ranges::count(roots, Complex(doubled)) == 2);
    }
    // x^3 at its point of inflection
    CHECK(nmbcgen::LevelRoots({0, 0, 0, 1}).at(0).size() == 3);
    // Beside an extremum two roots are close: real below it, complex above.
    constexpr double near = 1e-6;
    for (const double sign : {1.0, -1.0}) {
        const auto roots = nmbcgen::LevelRoots({0, 0, -1}).at(-sign * near * near);
        CHECK(std::abs(roots[0] - roots[1]) == doctest::Approx(2 * near).epsilon(1e-12));
        CHECK((roots[0].imag() == 0) == (sign > 0));
    }
}

TEST_CASE("a root far out, of a leading coefficient that is nearly 0") {
    // x^2 + 1e-12 x^3 is 1 at -1e12, 1 and -1, but for 1e-12 of each
    const auto roots = nmbcgen::LevelRoots({0, 0, 1, 1e-12}).at(1);
    REQUIRE(roots.size() == 3);
    for (const double root : {-1e12, -1.0, 1.0}) {
        CHECK(std::ranges::count_if(roots, [root](Complex x) {
                  return x.imag() == 0 && std::abs(x.real() / root - 1) < 1e-11;
              }) == 1);
    }
}

TEST_CASE("the roots at a level are those of a companion matrix") {
    // omega^2 of nopd1d, n = 3, in x = cos xi looks like this
    const std::vector<double> p{0.8, -1.3, 0.2, 0.9, -0.7, -0.1, 0.2};
    const nmbcgen::LevelRoots levels(p);
    for (int i = 1; i < 40; ++i) {
        const double y = 0.05 * i;
        std::vector<double> at_level = p;
        at_level[0] -= y;
        const auto expected = nmbcgen::polynomial_roots(at_level);
        const auto found = levels.at(y);
        REQUIRE(found.size() == expected.size());
        for (const Complex root : expected) {
            const auto distance = [root](Complex x) { return std::abs(x - root); };
            // Both are polished to the roundings of p; no two roots are closer than 0.01.
            CHECK(distance(*std::ranges::min_element(found, {}, distance)) < 1e-12);
        }
    }
}
