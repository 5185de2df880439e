// SPDX-License-Identifier: GPL-2.0-or-later
/// True reflection: against the boundary conditions it solves, and closed forms.
#include <doctest/doctest.h>

#include <cmath>

#include "generator/pipeline.hpp"
#include "generator/stability/reflection.hpp"

namespace {

using Complex = std::complex<double>;
using nmbcgen::Rational;

TEST_CASE("incident plus reflected waves satisfy interior and ghost layers") {
    for (const auto& [horizon, order, stride] : {std::tuple{1U, 2U, 1U}, std::tuple{2U, 1U, 1U},
                                                 std::tuple{2U, 3U, 2U}, std::tuple{3U, 2U, 3U}}) {
        const auto table = nmbcgen::derive({"nopd1d", horizon, order, stride, std::nullopt});
        const auto h = nmbcgen::make_half_space(table, Rational(3) / 10);
        for (const double xi : {0.2, 0.7, 1.3, 2.1}) {
            const double omega = std::sqrt(nmbcgen::omega_squared(h, xi));
            const auto R = nmbcgen::reflection(h, omega);
            REQUIRE(R.outgoing.size() == 2 * std::size_t(horizon));
            for (const auto& mode : R.outgoing) {
                Complex interior = h.symbol[0] - omega * omega;
                for (std::size_t m = 1; m < h.symbol.size(); ++m) {
                    interior += h.symbol[m] * (std::pow(mode.k, m) + std::pow(mode.k, -int(m)));
                }
                // k^-m of a fast decaying wave multiplies the roundings of k.
                CHECK(std::abs(interior) < 1e-12 * std::pow(std::abs(mode.k), -int(h.reach())));
                CHECK(std::abs(mode.k) < 1 + 1e-12);
            }
            for (Eigen::Index incident = 0; incident < R.amplitudes.cols(); ++incident) {
                for (int M = 0; M < 2 * int(horizon); ++M) {  // s C u = B u on every ghost layer
                    const auto term = [&](Complex k) {
                        return (Complex(0, omega) * evaluate_C(h, k) - evaluate_B(h, k)) *
                               std::pow(k, -M);
                    };
                    const Complex in = term(1.0 / R.outgoing[std::size_t(incident)].k);
                    Complex sum = in;
                    double size = std::abs(in);
                    for (Eigen::Index o = 0; o < R.amplitudes.rows(); ++o) {
                        const Complex out =
                            R.amplitudes(o, incident) * term(R.outgoing[std::size_t(o)].k);
                        sum += out;
                        size += std::abs(out);
                    }
                    CHECK(std::abs(sum) < 1e-10 * size);  // a Vandermonde system of up to 6
                }
            }
        }
    }
}

TEST_CASE("the atom chain's NMBC1 reflects tan^2(xi/4)") {
    // n = 1, G = 1/2: omega = 2 sin(xi/2), B/C = 2i tan(xi/2), so the scalar R is
    // (cos(xi/2) - 1)/(cos(xi/2) + 1). Only one wave travels, and NMBC1 is exact for the decaying
    // one's partner by symmetry of the Vandermonde factor: |true R| is the same.
    const auto table = nmbcgen::derive({"nopd1d", 1, 1, 1, std::nullopt});
    const auto h = nmbcgen::make_half_space(table, Rational(1) / 2);
    for (const double xi : {0.1, 1.0, 2.0, 3.0}) {
        const double expected = std::pow(std::tan(xi / 4), 2);
        CHECK(std::abs(nmbcgen::scalar_reflection(h, xi)) == doctest::Approx(expected));
    }
}

TEST_CASE("the supremum over phases") {
    Eigen::MatrixXcd one(1, 1);
    one << Complex(0.6, 0.8);
    CHECK(nmbcgen::phase_supremum(one) == doctest::Approx(1));
    // [[0, a], [b, 0]]: rho = sqrt(ab) whatever the phases, sigma_max = max(a, b)
    Eigen::MatrixXcd swap(2, 2);
    swap << 0, 4, 1, 0;
    CHECK(nmbcgen::phase_supremum(swap) == doctest::Approx(2).epsilon(1e-9));
    // A cycle of three: the cube root of the product.
    Eigen::MatrixXcd cycle = Eigen::MatrixXcd::Zero(3, 3);
    cycle(0, 1) = 9;
    cycle(1, 2) = Complex(0, 3);
    cycle(2, 0) = 1;
    CHECK(nmbcgen::phase_supremum(cycle) == doctest::Approx(3).epsilon(1e-9));
    // All ones: phases can line up, rho = n.
    CHECK(nmbcgen::phase_supremum(Eigen::MatrixXcd::Ones(4, 4)) == doctest::Approx(4));
}

}  // namespace
