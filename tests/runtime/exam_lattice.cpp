// SPDX-License-Identifier: GPL-2.0-or-later
/// Stencil, band and energy of the lattice, against the paper's formulas in floating point.
#include <doctest/doctest.h>

#include <cmath>
#include <nmbc/lattice.hpp>
#include <nmbc/tables/tables.hpp>
#include <numbers>

namespace {

nmbc::Lattice lattice_of(int horizon, double G) {
    const auto* table = nmbc::find_table(nmbc::generated::tables, "nopd1d", horizon, 1);
    REQUIRE(table != nullptr);
    return nmbc::make_lattice(*table, G);
}

/// (41) with dX = c = 1, as printed.
double printed_omega_squared(int n, double G, double xi) {
    double S = 0;
    double C = 0;
    for (int m = 1; m <= n; ++m) {
        S += m * std::sin(m * xi);
        C += std::cos(m * xi) - 1;
    }
    const double A = n * (n + 1) * (2 * n + 1) / 3.0;
    return 4 * (S * S / (A * A) - G / std::pow(n, 4) * (C + S * S / A));
}

TEST_CASE("the band is (41)") {
    for (int n = 1; n <= 5; ++n) {
        for (const double G : {0.0, 0.4, 1.7}) {
            const auto lattice = lattice_of(n, G);
            CHECK(lattice.reach() == std::size_t(2 * n));
            for (double xi = 0; xi < 3.2; xi += 0.1) {
                // Sums of at most 11 terms below 4(1 + G): a few eps of that.
                CHECK(nmbc::omega_squared(lattice, xi) ==
                      doctest::Approx(printed_omega_squared(n, G, xi))
                          .epsilon(0)
                          .scale(1)
                          .epsilon(1e-14));
            }
        }
    }
}

TEST_CASE("the slope of omega^2") {
    for (int n = 1; n <= 5; ++n) {
        for (const double G : {0.0, 0.4, 1.7}) {
            const auto lattice = lattice_of(n, G);
            for (double xi = 0.05; xi < 3.1; xi += 0.1) {
                constexpr double h = 1e-4;
                const double difference =
                    (nmbc::omega_squared(lattice, xi + h) - nmbc::omega_squared(lattice, xi - h)) /
                    (2 * h);
                // omega^2 has terms up to cos(2n xi), so the difference is off by up to h^2/6 of
                // (2n)^3 sum 2 |symbol|: 1e-8/6 * 1000 * 30; its roundings are 1e-15/h.
                CHECK(nmbc::omega_squared_slope(lattice, xi) ==
                      doctest::Approx(difference).epsilon(0).scale(1).epsilon(5e-5));
            }
            // Long waves travel at c: omega^2 = xi^2, but for terms of xi^4, at most 1e-2 here.
            CHECK(nmbc::omega_squared_slope(lattice, 1e-3) ==
                  doctest::Approx(2e-3).scale(0).epsilon(1e-4));
        }
    }
    // n = 1: omega^2 = sin(xi)^2 + 2G(1 - cos(xi))^2, so at xi = pi/2 the slope is 4G.
    CHECK(nmbc::omega_squared_slope(lattice_of(1, 0.5), std::numbers::pi / 2) ==
          doctest::Approx(2).epsilon(1e-15));
}

TEST_CASE("the largest frequency") {
    // n = 1, with x = cos xi: omega^2 = 1 - x^2 + 2G(1-x)^2 has its maximum at x = 2G/(2G-1) for
    // G < 1/4, and at x = -1 (value 8G) from there on.
    CHECK(nmbc::maximum_frequency(lattice_of(1, 0)) == doctest::Approx(1).epsilon(1e-15));
    CHECK(nmbc::maximum_frequency(lattice_of(1, 0.5)) == doctest::Approx(2).epsilon(1e-15));
    CHECK(nmbc::maximum_frequency(lattice_of(1, 2)) == doctest::Approx(4).epsilon(1e-15));
    // G = 1/8: x = -1/3, omega^2 = 1 - 1/9 + 1/4 * 16/9 = 4/3
    CHECK(nmbc::maximum_frequency(lattice_of(1, 0.125)) ==
          doctest::Approx(std::sqrt(4.0 / 3)).epsilon(1e-15));
    // No wave number is above it. n >= 2 has interior maxima.
    for (int n = 2; n <= 5; ++n) {
        for (const double G : {0.0, 0.3, 1.0, 2.5}) {
            const auto lattice = lattice_of(n, G);
            const double top = nmbc::maximum_frequency(lattice);
            double sampled = 0;
            for (int i = 0; i <= 100000; ++i) {
                sampled =
                    std::max(sampled, nmbc::omega_squared(lattice, i * std::numbers::pi / 100000));
            }
            // The grid misses the maximum by curvature * (pi/2e5)^2 / 2 < 1e-8 at the most.
            CHECK(top * top >= sampled * (1 - 1e-15));
            CHECK(top * top <= sampled * (1 + 1e-8));
        }
    }
}

/// operation(field, result): multiplies cos(xi j) by this factor within the ghosts, which it
/// leaves.
void check_plane_wave(const auto& operation, double xi, double factor, std::size_t ghosts) {
    std::vector<double> field(40);
    for (std::size_t i = 0; i < field.size(); ++i) {
        field[i] = std::cos(xi * double(i));
    }
    std::vector<double> result(field.size(), 99);
    operation(field, result);
    for (std::size_t i = 0; i < field.size(); ++i) {
        const bool ghost = i < ghosts || i >= field.size() - ghosts;
        const double expected = ghost ? 99 : factor * field[i];
        CHECK(result[i] == doctest::Approx(expected).epsilon(1e-13));  // 13 terms, some cancel
    }
}

TEST_CASE("a plane wave is accelerated by -omega^2") {
    const auto lattice = lattice_of(3, 0.6);
    constexpr double xi = 0.7;
    constexpr double stiffness = 2.5;
    check_plane_wave([&](const auto& u, auto& a) { nmbc::accelerations(lattice, stiffness, u, a); },
                     xi, -stiffness * nmbc::omega_squared(lattice, xi), 6);
}

TEST_CASE("a plane wave of a damped lattice is braked by its symbol") {
    nmbc::Lattice lattice = lattice_of(1, 0.6);
    lattice.damping = {0.75, -0.5, 0.125};
    constexpr double xi = 0.7;
    constexpr double rate = 2.5;
    check_plane_wave([&](const auto& v, auto& d) { nmbc::decelerations(lattice, rate, v, d); }, xi,
                     rate * (0.75 - std::cos(xi) + 0.25 * std::cos(2 * xi)), 2);
}

TEST_CASE("the energy's squares add up to the band") {
    for (int n = 1; n <= 5; ++n) {
        const auto lattice = lattice_of(n, 0.8);
        for (double xi = 0; xi < 3.2; xi += 0.3) {
            double sum = 0;
            for (const auto& square : lattice.energy) {
                double re = 0;
                double im = 0;
                for (std::size_t i = 0; i < square.stencil.size(); ++i) {
                    re += square.stencil[i] * std::cos(xi * double(i));
                    im += square.stencil[i] * std::sin(xi * double(i));
                }
                sum += square.weight * (re * re + im * im);
            }
            // At most 11 squares of 11 terms each, omega^2 of order 1.
            CHECK(sum - nmbc::omega_squared(lattice, xi) ==
                  doctest::Approx(0).scale(1).epsilon(1e-14));
        }
    }
    CHECK(lattice_of(2, 0).energy.size() == 1);  // no stabilisation squares at G = 0
}

}  // namespace
