// SPDX-License-Identifier: MIT
/// The continuum limit of 2D NOPD against literal sums over ever larger families.
#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "generator/exact/rational.hpp"
#include "generator/families/vector_family.hpp"

using namespace nmbcgen;

namespace {

const VectorChoice of_two{.radius_squared = 4, .poisson = Rational(1, 4)};
constexpr double delta = 2;
constexpr double bulk = 2.0 / 3;  // 1/(2 (1 - nu))
constexpr double P_speed_squared = 16.0 / 15;
constexpr double S_speed_squared = 2.0 / 5;

/// omega^2 of P and S on a lattice k times as fine, with the stabilisation k^2 g, by the closed
/// form (exam_nopd2d.cpp): c^2 |kappa|^2 + (12 k^2 g bulk/((k delta)^4 m)) (2 q - A |kappa|^2).
std::array<double, 2> on_lattice(int k, double g, double xi, double angle) {
    const double radius = k * delta;
    const int bound = int(radius);
    double bonds = 0;
    double shape = 0;
    double x = 0;
    double y = 0;
    double q = 0;
    for (int i = -bound; i <= bound; ++i) {
        for (int j = -bound; j <= bound; ++j) {
            if (i * i + j * j > radius * radius || (i == 0 && j == 0)) {
                continue;
            }
            const double t = xi / k * (i * std::cos(angle) + j * std::sin(angle));
            bonds += 1;
            shape += i * i;
            x += i * std::sin(t);
            y += j * std::sin(t);
            q += 1 - std::cos(t);
        }
    }
    const double kappa_squared = (x * x + y * y) / (shape * shape);
    const double rest =
        12 * k * k * g * bulk / (std::pow(radius, 4) * bonds) * (2 * q - shape * kappa_squared);
    return {k * k * (P_speed_squared * kappa_squared + rest),
            k * k * (S_speed_squared * kappa_squared + rest)};
}

}  // namespace

TEST_CASE("lattices of the same radius tend to the limit, at every angle") {
    for (const double g : {0.0, 0.4}) {
        for (const double xi : {0.3, 1.0, 2.0, 3.1}) {
            const PlaneLimit limit = nopd2d_limit(of_two, g, xi);
            for (const double angle : {0.0, 0.3, 0.7}) {
                const auto at = [&](int k) { return on_lattice(k, g, xi, angle); };
                const auto [coarse_P, coarse_S] = at(10);
                const auto [P, S] = at(160);
                // Sums over the nodes in a disc of radius r are off by about r^-1.3 of themselves:
                // 5e-4 at 320. Where waves have no energy, of the largest omega^2 there is.
                CHECK(P == doctest::Approx(limit.P).epsilon(1e-3));
                CHECK(S == doctest::Approx(limit.S).epsilon(1e-3));
                CHECK(std::abs(P - limit.P) <= std::abs(coarse_P - limit.P));
                CHECK(std::abs(S - limit.S) <= std::abs(coarse_S - limit.S));
            }
        }
    }
}

TEST_CASE("the limit's slope is its derivative") {
    constexpr double step = 1e-5;  // the next term is step^2 smaller
    for (const double xi : {0.2, 1.3, 2.9}) {
        const PlaneLimit at = nopd2d_limit(of_two, 0.3, xi);
        const PlaneLimit above = nopd2d_limit(of_two, 0.3, xi + step);
        const PlaneLimit below = nopd2d_limit(of_two, 0.3, xi - step);
        CHECK((above.P - below.P) / (2 * step) == doctest::Approx(at.P_slope).epsilon(1e-8));
        CHECK((above.S - below.S) / (2 * step) == doctest::Approx(at.S_slope).epsilon(1e-8));
    }
}

TEST_CASE("delta to 0: long waves, omega = c xi") {
    const PlaneLimit limit = nopd2d_limit(of_two, 0.3, 1e-3);  // the next term is xi^2 smaller
    CHECK(limit.P == doctest::Approx(P_speed_squared * 1e-6).epsilon(1e-5));
    CHECK(limit.S == doctest::Approx(S_speed_squared * 1e-6).epsilon(1e-5));
}

TEST_CASE("delta to infinity: no waves, a node in a body that does not see it") {
    // J_n falls like x^(-1/2): kappa^2 like x^-3, the rest but 2 like x^(-3/2).
    constexpr double xi = 1e4;
    const double alone = 24 * 0.3 * bulk / std::pow(delta, 4);
    CHECK(nopd2d_limit(of_two, 0.3, xi).P == doctest::Approx(alone).epsilon(1e-5));
    CHECK(nopd2d_limit(of_two, 0, xi).P < 1e-8);
}

TEST_CASE("zero-energy modes of the limit, G = 0: zeros of J_2") {
    for (const double zero : {5.135622301840683, 8.417244140399864}) {
        CHECK(nopd2d_limit(of_two, 0, zero / delta).P < 1e-25);
    }
}
