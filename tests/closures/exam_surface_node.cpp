// SPDX-License-Identifier: GPL-2.0-or-later
/// Rows of the surface node method, and the paper's Fig. 3: a bar with both of its ends.
#include <doctest/doctest.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <nmbc/chain.hpp>
#include <nmbc/surface.hpp>
#include <numbers>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "generator/closures/surface_node.hpp"
#include "generator/dense/decompositions.hpp"
#include "generator/exact/rational.hpp"

using namespace nmbcgen;

namespace {

std::string row_text(unsigned horizon, bool corrected) {
    std::string text;
    for (const Rational& entry : surface_node(horizon, corrected).row) {
        text += (text.empty() ? "" : " ") + to_string(entry);
    }
    return text;
}

/// Si(x), the sum of its series.
double sine_integral(double x) {
    double term = x;
    double sum = x;
    for (int n = 1; n < 100; ++n) {
        term *= -x * x / ((2.0 * n) * (2.0 * n + 1));
        sum += term / (2 * n + 1);
    }
    return sum;
}

constexpr double horizon_length = 0.1;  // of a bar of length 1 [m]

double omega_over_speed(double k) {
    const double phase = k * horizon_length;
    return std::sqrt(2 * (phase * sine_integral(phase) + std::cos(phase) - 1)) / horizon_length;
}

/// omega_1 = 7851.29098 of the paper's bar [1/s].
double speed() {
    return 7851.29098 / omega_over_speed(std::numbers::pi / 2);
}

/// (7): fixed at x = 0, free at x = 1.
double series(double x, double t) {
    double sum = 0;
    for (int m = 1; m <= 40; ++m) {
        const double k = (2 * m - 1) * std::numbers::pi / 2;
        sum += std::sqrt(std::numbers::pi) / 250 * std::sin(k / 2) * std::exp(-k * k / 400) *
               std::sin(k * x) * std::cos(speed() * omega_over_speed(k) * t);
    }
    return sum;
}

/// Bonds of (2), in units dX = c = 1, where c is the speed that horizon_length is meant for.
nmbc::Lattice chain_of(const SurfaceNode& closure) {
    const std::size_t m = closure.quadrature.size();
    nmbc::Lattice lattice;
    lattice.symbol.resize(m + 1);
    for (std::size_t k = 1; k <= m; ++k) {
        lattice.symbol[k] = -nearest_double(closure.quadrature[k - 1]) / double(m * k * k);
        lattice.symbol[0] -= 2 * lattice.symbol[k];
        std::vector<double> bond(2 * k + 1);
        bond[k] = -1;
        bond[2 * k] = 1;
        lattice.energy.push_back({nmbc::EnergyPart::strain, -lattice.symbol[k], bond});
    }
    return lattice;
}

/// The bar of Fig. 3: nodes at (i + 1/2)/count, held at x = 0 and free at x = 1.
class Bar {
  public:
    Bar(std::size_t count, nmbc::Closure closure, bool corrected, double dt)
        : count_(count),
          chain_(chain_of(surface_node(unsigned(std::lround(horizon_length * double(count))),
                                       corrected)),
                 nmbc::SurfaceEnd{closure, nmbc::OnSurface::displacement, {}},
                 nmbc::SurfaceEnd{closure, nmbc::OnSurface::traction, {}},
                 {.nodes = count,
                  .spacing = 1 / double(count),
                  .youngs_modulus = speed() * speed(),
                  .density = 1,
                  .time_step = dt}) {
        std::vector<double> u(chain_.nodes());
        for (std::size_t i = 0; i < count; ++i) {
            u[chain_.first_interior() + i] = start_at(i);
        }
        chain_.start(u, std::vector<double>(u.size()));
    }

    /// ||u - (7)||/||u_0|| at a later time.
    double error_at(double t) {
        while (chain_.time() < t * (1 - 1e-9)) {
            chain_.step();
        }
        double difference = 0;
        double start = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const double u = std::as_const(chain_).displacement()[chain_.first_interior() + i];
            difference += std::pow(u - series(place(i), t), 2);
            start += std::pow(start_at(i), 2);
        }
        return std::sqrt(difference / start);
    }

  private:
    double place(std::size_t i) const { return (double(i) + 0.5) / double(count_); }
    double start_at(std::size_t i) const {
        return 0.02 * std::exp(-100 * std::pow(place(i) - 0.5, 2));
    }

    std::size_t count_;
    nmbc::Chain chain_;
};

/// u'' = A u of a chain between two surfaces.
Eigen::MatrixXd stiffness_between(const nmbc::Lattice& lattice, nmbc::OnSurface left,
                                  nmbc::OnSurface right, std::size_t nodes) {
    const nmbc::ChainParameters p{.nodes = nodes, .time_step = 1e-3};
    const auto made = [&](nmbc::OnSurface given) {
        return nmbc::SurfaceEnd{nmbc::Closure::surface_node, given, {}}.make(
            lattice, p, std::type_identity<double>{});
    };
    const auto at_left = made(left);
    const auto at_right = made(right);
    Eigen::MatrixXd A(nodes, nodes);
    std::vector<double> u(nodes + 2 * lattice.reach());
    std::vector<double> v(u.size());
    std::vector<double> a(u.size());
    for (std::size_t node = 0; node < nodes; ++node) {
        std::ranges::fill(u, 0.0);
        u[lattice.reach() + node] = 1;
        at_left->start({u, nmbc::End::left}, {v, nmbc::End::left}, 0);
        at_right->start({u, nmbc::End::right}, {v, nmbc::End::right}, 0);
        nmbc::accelerations(lattice, 1, u, a);
        for (std::size_t row = 0; row < nodes; ++row) {
            A(Eigen::Index(row), Eigen::Index(node)) = a[lattice.reach() + row];
        }
    }
    return A;
}

}  // namespace

TEST_CASE("rows, worked out with an algebra system") {
    CHECK(row_text(1, false) == "1");
    CHECK(row_text(2, false) == "21/22 1/22");
    CHECK(row_text(3, false) == "137/150 11/150 1/75");
    CHECK(row_text(4, false) == "1409/1572 113/1572 41/1572 3/524");
    CHECK(row_text(2, true) == "29/30 1/30");
    CHECK(row_text(3, true) == "173/186 11/186 1/93");
    CHECK(row_text(4, true) == "1697/1860 113/1860 41/1860 3/620");
}

TEST_CASE("a shift and a uniform strain are kept, exactly, at every horizon") {
    for (unsigned m = 1; m <= largest_closure_horizon; ++m) {
        for (const bool corrected : {false, true}) {
            const SurfaceNode node = surface_node(m, corrected);
            Rational sum = 0;
            Rational strained = 0;  // u_i = -(i - 1/2)
            Rational modulus = 0;
            for (unsigned i = 1; i <= m; ++i) {
                CHECK(node.row[i - 1] > 0);
                sum += node.row[i - 1];
                strained -= node.row[i - 1] * Rational(2 * int(i) - 1, 2);
                modulus += node.quadrature[i - 1] / m;
                CHECK(node.ghosts[i - 1][0] + node.ghosts[i - 1][1] == 1);
            }
            CHECK(sum == 1);
            CHECK(modulus == (corrected ? Rational(1) : 1 - Rational(1, 2 * int(m))));
            // The surface is at x = 0: it stays there under the traction of this strain.
            CHECK(strained + node.load * modulus == 0);
        }
    }
}

TEST_CASE("the series' frequencies are the paper's") {
    CHECK(std::abs(speed() * omega_over_speed(79 * std::numbers::pi / 2) - 304274.639) < 6e-4);
}

TEST_CASE("Fig. 3: errors at 0.1, 0.2 and 0.4 ms as listed, of the printed and corrected chain" *
          doctest::test_suite("long")) {
    using enum nmbc::Closure;
    struct Column {
        std::size_t count;
        nmbc::Closure closure;
        bool corrected;
        std::array<double, 3> percent;
        double last_digit;
    };
    for (const Column& column : {Column{100, cut, false, {25.3, 48.4, 82.3}, .1},
                                 Column{500, cut, false, {32.1, 57.5, 91.4}, .1},
                                 Column{1000, cut, false, {34.8, 61.8, 98.5}, .1},
                                 Column{100, surface_node, false, {9.36, 20.0, 35.8}, .1},
                                 Column{100, surface_node, true, {.18, .32, .28}, .01},
                                 Column{100, mirror, true, {.093, .175, .384}, .001},
                                 Column{500, surface_node, false, {1.83, 4.11, 6.74}, .01},
                                 Column{500, surface_node, true, {.13, .27, .38}, .01},
                                 Column{500, mirror, true, {.0015, .0029, .0064}, .0001},
                                 Column{1000, surface_node, false, {.905, 2.03, 3.22}, .01},
                                 Column{1000, surface_node, true, {.126, .26, .36}, .01},
                                 Column{1000, mirror, true, {.0037, .0070, .0155}, .0001}}) {
        CAPTURE(column.count);
        CAPTURE(column.corrected);
        constexpr double dt = 2e-7;  // in shorter ones the mirror has .0959, .180, .398
        Bar bar(column.count, column.closure, column.corrected, dt);
        constexpr std::array<double, 3> times{1e-4, 2e-4, 4e-4};
        for (std::size_t i = 0; i < times.size(); ++i) {
            CHECK(std::abs(100 * bar.error_at(times[i]) - column.percent[i]) < column.last_digit);
        }
    }
}

TEST_CASE("the runtime finds the rows that are derived here") {
    for (const unsigned m : {1U, 2U, 3U, 7U, 20U}) {
        for (const bool corrected : {false, true}) {
            const SurfaceNode node = surface_node(m, corrected);
            const auto ghosts =
                nmbc::detail::surface_node_rows(chain_of(node), nmbc::OnSurface::traction);
            for (std::size_t f = 0; f < m; ++f) {
                const double of_surface = nearest_double(node.ghosts[f][0]);
                for (std::size_t i = 0; i < m; ++i) {
                    const double own = i == 0 ? nearest_double(node.ghosts[f][1]) : 0;
                    CHECK(ghosts.rows[f * m + i] ==
                          doctest::Approx(of_surface * nearest_double(node.row[i]) + own)
                              .epsilon(1e-13));
                }
                CHECK(ghosts.given[f] ==
                      doctest::Approx(of_surface * nearest_double(node.load)).epsilon(1e-13));
            }
        }
    }
}

TEST_CASE("the spectrum is real and not positive, and within the bound for steps") {
    using enum nmbc::OnSurface;
    for (const unsigned m : {1U, 2U, 3U, 5U, 10U}) {
        const nmbc::Lattice lattice = chain_of(surface_node(m, true));
        for (const auto& [left, right] : {std::pair(displacement, displacement),
                                          {displacement, traction},
                                          {traction, traction}}) {
            for (const std::size_t nodes :
                 {std::size_t(m), std::size_t(2 * m + 1), std::size_t(80)}) {
                CAPTURE(m);
                CAPTURE(nodes);
                const Eigen::VectorXcd lambda =
                    eigenvalues(stiffness_between(lattice, left, right, nodes));
                const double top =
                    nmbc::largest_eigenvalue(lattice, nmbc::Closure::surface_node, left, nodes);
                constexpr double roundings =
                    1e-9;  // 1e-13 top, and a root of that for a double one
                CHECK(lambda.imag().cwiseAbs().maxCoeff() < roundings);
                CHECK(lambda.real().maxCoeff() < roundings);
                CHECK(-lambda.real().minCoeff() <= top);
                if (left == right) {
                    CHECK(top < 1.02 * std::max(-lambda.real().minCoeff(),
                                                std::pow(nmbc::maximum_frequency(lattice), 2)));
                }
            }
        }
    }
}

TEST_CASE("the longest step of the paper's finest bar is 1.20 us, by its held end") {
    constexpr std::size_t nodes = 1000;
    const nmbc::Lattice lattice = chain_of(surface_node(100, false));
    const auto longest = [&](nmbc::OnSurface given) {
        constexpr double above = 1.01;  // the eigenvalue, as largest_eigenvalue() says
        return 2 / (speed() * double(nodes)) *
               std::sqrt(above /
                         largest_eigenvalue(lattice, nmbc::Closure::surface_node, given, nodes));
    };
    CHECK(std::abs(longest(nmbc::OnSurface::displacement) - 1.20e-6) < 0.005e-6);
    CHECK(longest(nmbc::OnSurface::traction) > 1.20e-6);
}

TEST_CASE("horizons that there are not") {
    CHECK_THROWS_AS(surface_node(0, false), std::invalid_argument);
    CHECK_THROWS_AS(surface_node(largest_closure_horizon + 1, true), std::invalid_argument);
}
