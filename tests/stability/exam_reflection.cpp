// SPDX-License-Identifier: GPL-2.0-or-later
/// True reflection: against the boundary conditions it solves, and closed forms.
#include <doctest/doctest.h>

#include <cmath>

#include "generator/dense/decompositions.hpp"
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
                        const auto [C, B] = evaluate_condition(h, k);
                        return (Complex(0, omega) * C - B) * std::pow(k, -M);
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
        CHECK(std::abs(nmbcgen::scalar_reflection(h, xi)) ==
              doctest::Approx(expected).epsilon(1e-9).scale(0));
        const auto R = nmbcgen::reflection(h, std::sqrt(omega_squared(h, xi)));
        REQUIRE(R.matrix.size() == 1);
        CHECK(std::abs(R.matrix(0, 0)) == doctest::Approx(expected).epsilon(1e-9).scale(0));
    }
}

/// The largest rho(R_1 D R_2 D') that is found by turning phases, one after the other, by ever
/// smaller angles, from several starts: a bound from below that knows no theory.
double largest_found(const Eigen::MatrixXcd& one, const Eigen::MatrixXcd& other) {
    const Eigen::Index waves = one.rows();
    double best = 0;
    for (int start = 0; start < 6; ++start) {
        Eigen::VectorXd angles(2 * waves);
        for (Eigen::Index i = 0; i < 2 * waves; ++i) {
            angles(i) = 2.4 * double(start * (i + 1) * (i + 1));
        }
        const auto radius = [&](const Eigen::VectorXd& at) {
            const Eigen::VectorXcd phases = (Complex(0, 1) * at).array().exp();
            const Eigen::MatrixXcd trip =
                one * phases.head(waves).asDiagonal() * other * phases.tail(waves).asDiagonal();
            return nmbcgen::eigenvalues(trip).cwiseAbs().maxCoeff();
        };
        double value = radius(angles);
        for (double turn = 1; turn > 1e-6;) {
            bool better = false;
            for (Eigen::Index i = 0; i < 2 * waves; ++i) {
                for (const double sign : {1.0, -1.0}) {
                    Eigen::VectorXd turned = angles;
                    turned(i) += sign * turn;
                    if (const double found = radius(turned); found > value) {
                        value = found;
                        angles = turned;
                        better = true;
                    }
                }
            }
            turn *= better ? 1 : 0.5;
        }
        best = std::max(best, value);
    }
    return best;
}

TEST_CASE("the supremum of a round trip is reached by phases, and not passed") {
    const auto half_space = [](unsigned horizon, unsigned order, unsigned stride, double G) {
        return make_half_space(nmbcgen::derive({"nopd1d", horizon, order, stride, std::nullopt}),
                               Rational(G));
    };
    struct Pair {
        nmbcgen::HalfSpace left;
        nmbcgen::HalfSpace right;
    };
    const std::vector<Pair> pairs{
        {half_space(1, 1, 1, 0.1), half_space(1, 2, 1, 0.1)},  // a backward band
        {half_space(2, 1, 1, 0), half_space(2, 1, 1, 0)},      // up to four waves
        {half_space(2, 2, 2, 0.3), half_space(2, 1, 1, 0.3)},  //
        {half_space(3, 1, 1, 0), half_space(3, 2, 3, 0)},      // up to six
        {half_space(3, 1, 1, 1.5), half_space(3, 1, 1, 1.5)}};
    std::size_t most_waves = 0;
    for (const Pair& pair : pairs) {
        for (const double omega : {0.05, 0.1, 0.2, 0.4, 0.6, 0.9}) {
            const auto left = nmbcgen::reflection(pair.left, omega);
            const auto right = nmbcgen::reflection(pair.right, omega);
            if (left.matrix.rows() == 0) {
                continue;
            }
            most_waves = std::max(most_waves, std::size_t(left.matrix.rows()));
            const double supremum = nmbcgen::round_trip_supremum(left, right);
            CAPTURE(omega);
            CAPTURE(left.matrix.rows());
            const double found = largest_found(left.matrix, right.matrix);
            CHECK(found <= supremum * (1 + 1e-9));  // roundings of eigenvalues
            CHECK(found >= supremum * (1 - 1e-6));  // angles are turned to within 1e-6
        }
    }
    CHECK(most_waves >= 5);
}

}  // namespace
