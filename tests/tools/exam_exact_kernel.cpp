// SPDX-License-Identifier: GPL-2.0-or-later
/// The kernel of an exact end, and the convolution with it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nmbc/nmbc.hpp>
#include <random>
#include <vector>

#include "tests/tools/exact_cases.hpp"
#include "tools/nmbcrun/ends/online_convolution.hpp"
#include "tools/nmbcrun/ends/transparent_kernel.hpp"

namespace {

using Kernel = std::vector<std::vector<double>>;

/// (56), in units of its own spring and mass.
const nmbc::Lattice atoms{.symbol = {2, -1}, .energy = {}, .damping = {}};

using Long = std::vector<long double>;

long double applied(const Long& stencil, const Long& field, std::size_t node) {
    long double sum = stencil.empty() ? 0.0L : stencil[0] * field[node];
    for (std::size_t m = 1; m < stencil.size(); ++m) {
        sum += stencil[m] * (field[node + m] + field[node - m]);
    }
    return sum;
}

/// Leapfrog in a half line so long that nothing returns, node 1-i moved by 1 at level 0 only; what
/// node 1 does is kernel[i-1]. In long double, whose roundings are none in double.
Long response(const nmbc::Lattice& lattice, double courant, std::size_t i, std::size_t steps) {
    const Long symbol(lattice.symbol.begin(), lattice.symbol.end());
    const Long damping(lattice.damping.begin(), lattice.damping.end());
    const auto dt = static_cast<long double>(courant);
    const std::size_t r = lattice.reach();
    const std::size_t nodes = r * (steps / 2 + 2);
    Long u(nodes + 2 * r);
    Long v(u.size());  // times dt
    Long result{0};
    u[r - i] = 1;
    v[r - i] = 1;
    for (std::size_t k = 0; k < steps; ++k) {
        const auto old = v;
        for (std::size_t node = r; node < r + nodes; ++node) {
            v[node] -= dt * (dt * applied(symbol, u, node) + applied(damping, old, node));
        }
        for (std::size_t node = r; node < r + nodes; ++node) {
            u[node] += v[node];
        }
        v[r - i] = k == 0 ? -1 : 0;
        u[r - i] = 0;
        result.push_back(u[r]);
    }
    return result;
}

TEST_CASE("the kernel is the half line's answer to unit impulses") {
    constexpr std::size_t steps = 100;
    // 1/2 and 0.5000001: at n = 1 the outermost coefficient is 0, and next to it.
    for (const Case& one :
         cases({1, 2, 3, 5}, {0.0, 0.5, 0.5000001, 1.0}, {0.02, 0.3, 0.95, 1.0})) {
        const auto lattice = lattice_of(one.horizon, one.G, one.tau);
        const double courant = courant_of(lattice, one.cfl);
        const Kernel kernel = nmbcrun::transparent_kernel(lattice, courant, steps);
        REQUIRE(kernel.size() == lattice.reach());
        for (std::size_t i = 1; i <= kernel.size(); ++i) {
            const Long expected = response(lattice, courant, i, steps);
            double error = 0;
            for (std::size_t m = 0; m <= steps; ++m) {
                error += std::abs(kernel[i - 1][m] - double(expected[m]));
            }
            CAPTURE(one);
            // To the last bit: 101 entries, a few of them near 1, of up to eps each.
            CHECK(error < 5e-15);
        }
    }
}

TEST_CASE("the kernel of the atom chain solves its quadratic equation") {
    // (1-q)^2 lambda = courant^2 q (1 - lambda)^2, q = 1/z, power by power.
    constexpr std::size_t steps = 2000;
    for (const double courant : {0.1, 0.5, 0.9, 1.0}) {
        std::vector<double> expected(steps + 1);
        for (std::size_t m = 1; m <= steps; ++m) {
            double squares = m == 1 ? 1 : 0;
            for (std::size_t j = 1; j + 1 < m; ++j) {
                squares += expected[j] * expected[m - 1 - j];
            }
            expected[m] = courant * courant * squares +
                          (2 - 2 * courant * courant) * expected[m - 1] -
                          (m > 1 ? expected[m - 2] : 0);
        }
        const Kernel kernel = nmbcrun::transparent_kernel(atoms, courant, steps);
        CAPTURE(courant);
        for (std::size_t m = 0; m <= steps; ++m) {
            // The recurrence's own roundings: sqrt(2000) of values below 1/10 and of sums of those.
            CHECK(std::abs(kernel[0][m] - expected[m]) < 5e-15);
        }
    }
    // courant = 1: every wave moves on by a node a step.
    const Kernel shift = nmbcrun::transparent_kernel(atoms, 1, 100);
    for (std::size_t m = 0; m <= 100; ++m) {
        CHECK(std::abs(shift[0][m] - (m == 1 ? 1 : 0)) < 1e-17);  // in long double
    }
}

TEST_CASE("in short steps the atom chain's kernel is 2 J_2(2t)/t") {
    double before = 0;
    for (const double dt : {0.04, 0.02, 0.01}) {
        const auto steps = std::size_t(std::lround(20 / dt));
        const Kernel kernel = nmbcrun::transparent_kernel(atoms, dt, steps);
        double error = 0;
        for (std::size_t m = 1; m <= steps; ++m) {
            const double t = double(m) * dt;
            error = std::max(error,
                             std::abs(kernel[0][m] / dt - 2 * std::cyl_bessel_j(2.0, 2 * t) / t));
        }
        CHECK(error < 0.2 * dt * dt);  // 0.18 dt^2: leapfrog is of second order
        if (before > 0) {
            CHECK(before / error == doctest::Approx(4).scale(0).epsilon(0.02));
        }
        before = error;
    }
}

TEST_CASE("blocks of a convolution give what plain sums do") {
    std::mt19937_64 random(20180417);
    std::normal_distribution<double> normal;
    for (const std::size_t steps : {1U, 2U, 31U, 32U, 33U, 64U, 65U, 500U, 1024U}) {
        Kernel kernel(3, std::vector<double>(steps + 1));
        for (auto& values : kernel) {
            std::ranges::generate(values, [&] { return normal(random); });
        }
        nmbcrun::OnlineConvolution convolution(kernel);
        std::vector<std::vector<double>> x(5);
        for (std::size_t k = 1; k <= steps; ++k) {
            std::vector<double> given;
            given.reserve(x.size());
            for (auto& values : x) {
                values.push_back(normal(random));
                given.push_back(values.back());
            }
            std::vector<double> y(3);
            convolution.advance(given, y);
            for (std::size_t e = 0; e < 3; ++e) {
                long double expected = 0;
                for (std::size_t i = 1; i <= 3; ++i) {
                    for (std::size_t m = 1; m <= k; ++m) {
                        expected += static_cast<long double>(kernel[i - 1][m]) *
                                    static_cast<long double>(x[e + i - 1][k - m]);
                    }
                }
                // Sums of up to 200, whose last bit is 3e-14, from ten transforms.
                CHECK(std::abs(y[e] - double(expected)) < 3e-13);
            }
        }
        CHECK(convolution.levels() == steps);
    }
}

}  // namespace
