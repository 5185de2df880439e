// SPDX-License-Identifier: GPL-2.0-or-later
/// Failure as a prediction: where the stability room says that a boundary grows, and how fast, the
/// runtime's chain grows at that rate.
#include <doctest/doctest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <nmbc/chain.hpp>
#include <nmbc/ends.hpp>
#include <random>
#include <span>
#include <vector>

#include "generator/stability/discrete.hpp"
#include "generator/stability/modal.hpp"
#include "generator/stability/round_trip.hpp"
#include "tests/stability/boundary.hpp"

namespace {

using nmbcgen::Failure;
using nmbcgen::test::Boundary;
using nmbcgen::test::relative;

/// What the project asks of a predicted growth rate. Found: 1e-3 at most, and 1.8e-2 for the t^2,
/// where what is left of it is a smaller power of t.
constexpr double tolerance = 0.05;

/// Random displacements and velocities on all nodes: some of every eigenvector.
void randomise(nmbc::Chain& chain) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (auto values : {chain.displacement(), chain.velocity()}) {
        std::ranges::generate(values, [&] { return normal(random); });
    }
}

nmbc::Chain random_chain(const Boundary& boundary, std::size_t nodes, double time_step) {
    const auto& table = committed_table(boundary);
    nmbc::Chain chain(
        nmbc::make_lattice(table, boundary.G),
        nmbc::MatchingEnd{nmbc::boundary_coefficients(table, boundary.G, nmbc::allow_unstable)},
        {.nodes = nodes, .time_step = time_step});
    randomise(chain);
    return chain;
}

/// Divides the state by the norm of its velocities, and returns that norm.
double normalise(nmbc::Chain& chain) {
    double squares = 0;
    for (const double v : chain.velocity()) {
        squares += v * v;
    }
    const double norm = std::sqrt(squares);
    for (auto values : {chain.displacement(), chain.velocity()}) {
        std::ranges::for_each(values, [norm](double& value) { value /= norm; });
    }
    return norm;
}

/// The slope of the line of least squares through (i, values[i]).
double slope(std::span<const double> values) {
    const double middle = (double(values.size()) - 1) / 2;
    double products = 0;
    double squares = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        products += (double(i) - middle) * values[i];
        squares += (double(i) - middle) * (double(i) - middle);
    }
    return products / squares;
}

/// The rate [c/dX] at which the velocities of a chain grow, fitted to the logarithm of their norm
/// over the second half of 100 e-foldings at about `expected`. By then waves that grow more than
/// the tolerance slower than the fastest are exp(-2.5) to exp(-5) of what they were beside it; and
/// that two of complex conjugate growth make the norm swing by a factor of order 1 tilts a line
/// over 50 e-foldings by less than 1 %.
double measured_growth(nmbc::Chain chain, double expected) {
    const double dt = chain.parameters().time_step;
    const auto between = std::size_t(std::ceil(0.25 / (expected * dt)));  // steps; 1/4 e-folding
    const auto samples = std::size_t(std::ceil(100 / (expected * dt * double(between))));
    std::vector<double> logarithms;
    double logarithm = 0;
    for (std::size_t i = 0; i < samples; ++i) {
        for (std::size_t step = 0; step < between; ++step) {
            chain.step();
        }
        logarithm += std::log(normalise(chain));
        logarithms.push_back(logarithm);
    }
    const auto late = std::span(logarithms).subspan(samples / 2);
    return slope(late) / (double(between) * dt);
}

/// ln |z| / dt of the largest eigenvalue z of the finite chain's one-step map.
double spectral_growth(const nmbcgen::HalfSpace& h, std::size_t nodes, double time_step) {
    const nmbcgen::LatticeEnd end{nmbcgen::LatticeEnd::Kind::matching, h};
    return std::log(nmbcgen::spectral_radius(end, end, nodes, time_step)) / time_step;
}

/// The length does not matter to a mode that decays from the end, and as dt -> 0 the step has the
/// s of the half space: at cfl 0.01 it differs from it by less than 1e-3.
TEST_CASE("a growing boundary mode grows at its half space's s, whatever the length") {
    for (const Boundary& boundary : {Boundary{2, 2, 1, 1}, Boundary{2, 3, 1, 1.2}}) {
        CAPTURE(boundary.order);
        const auto h = half_space(boundary);
        REQUIRE(nmbcgen::modal_verdict(h).failure == Failure::growing_mode);
        const double predicted = nmbcgen::growing_mode(h).value().real();
        const double time_step = 0.01 * 2 / nmbcgen::maximum_frequency(h);
        for (const std::size_t nodes : {20U, 41U}) {
            CAPTURE(nodes);
            const double measured =
                measured_growth(random_chain(boundary, nodes, time_step), predicted);
            CHECK(measured == relative(predicted, tolerance));
        }
    }
}

/// Waves that gain on every bounce: the rate falls with the length, about as 1/L, and lies in the
/// finite chain's spectrum. Which of them fits best depends on the length and its parity: at
/// n = 1, N = 3, G = 0.8, 20 nodes and 21 differ by a third.
TEST_CASE("amplified waves grow at the rate of the finite chain's largest eigenvalue") {
    struct Case {
        Boundary boundary;
        Failure failure;
        std::vector<std::size_t> lengths;
    };
    const std::vector<Case> cases{
        {{1, 2, 1, 0.1}, Failure::amplified_wave, {20, 41}},  // in the backward band
        {{1, 2, 1, 1.1}, Failure::resonance, {20, 41}},
        {{1, 3, 1, 0.8}, Failure::resonance, {20, 21}},
        {{2, 2, 1, 2}, Failure::resonance, {20, 41}},
    };
    for (const Case& each : cases) {
        const Boundary& boundary = each.boundary;
        CAPTURE(boundary.horizon);
        CAPTURE(boundary.order);
        CAPTURE(boundary.G);
        const auto h = half_space(boundary);
        CHECK(nmbcgen::modal_verdict(h).failure == each.failure);
        const double time_step = 0.2 * 2 / nmbcgen::maximum_frequency(h);
        for (const std::size_t nodes : each.lengths) {
            CAPTURE(nodes);
            const double predicted = spectral_growth(h, nodes, time_step);
            const double measured =
                measured_growth(random_chain(boundary, nodes, time_step), predicted);
            CHECK(measured == relative(predicted, tolerance));
        }
    }
}

/// Neither end grows with its like: NMBC1 is stable at every G, and a fixed end keeps the energy.
TEST_CASE("NMBC1 against a fixed end grows at the rate of the finite chain's largest eigenvalue") {
    for (const Boundary& boundary : {Boundary{1, 1, 1, 0.1}, Boundary{3, 1, 1, 1}}) {
        CAPTURE(boundary.horizon);
        const auto h = half_space(boundary);
        const nmbcgen::LatticeEnd matching{nmbcgen::LatticeEnd::Kind::matching, h};
        const nmbcgen::LatticeEnd fixed = nmbcgen::fixed_end(h);
        CHECK(nmbcgen::round_trip_verdict(matching, matching).failure == Failure::none);
        CHECK(nmbcgen::round_trip_verdict(matching, fixed).failure == Failure::amplified_wave);
        constexpr std::size_t nodes = 40;
        const double time_step = 0.2 * 2 / nmbcgen::maximum_frequency(h);
        const double radius = nmbcgen::spectral_radius(matching, fixed, nodes, time_step);
        const double predicted = std::log(radius) / time_step;
        REQUIRE(predicted > 1e-4);
        const auto& table = committed_table(boundary);
        nmbc::Chain chain(
            nmbc::make_lattice(table, boundary.G),
            nmbc::MatchingEnd{nmbc::boundary_coefficients(table, boundary.G, nmbc::allow_unstable)},
            nmbc::FixedEnd{}, {.nodes = nodes, .time_step = time_step});
        randomise(chain);
        CHECK(measured_growth(std::move(chain), predicted) == relative(predicted, tolerance));
    }
}

/// In time steps the fastest mode is the one of largest |zeta|, not of largest Re sigma.
TEST_CASE("of several growing modes the fastest is named") {
    const Boundary boundary{2, 2, 1, 1.85};
    const auto h = half_space(boundary);
    const double time_step = 0.8 * 2 / nmbcgen::maximum_frequency(h);
    const auto sigma = growing_mode(stepped(h, time_step));
    REQUIRE(sigma);
    const std::complex<double> half = *sigma * time_step / 2.0;
    const double said = std::log(std::abs((1.0 + half) / (1.0 - half))) / time_step;
    // Two mirrored modes of 40 nodes apart: the chain's own eigenvalue is the half space's.
    CHECK(said == relative(spectral_growth(h, 40, time_step), 1e-6));
}

/// NMBC3 at n = 1, G = 1 is (z - 1)^2 times NMBC1: besides 1 and t, u = (t^2 + x^2)/2 solves chain
/// and boundary, also step by step. Its share in a start is that of the left eigenvectors of the
/// one-step map at the eigenvalue 1: two, one for each end, made of displacements of the ghost
/// layers and velocities next to them. (So a pulse in the middle has no share in it, while any
/// error made at an end has.) The other solution they stand for is u = t x, which has no share in a
/// start that is even about the middle, x = 0.
TEST_CASE("a boundary with C(1) = 0 lets a constant grow like t^2") {
    const Boundary boundary{1, 3, 1, 1};
    const auto& table = committed_table(boundary);
    CHECK_THROWS_AS(nmbc::boundary_coefficients(table, boundary.G), nmbc::CoefficientError);
    const auto h = half_space(boundary);
    constexpr std::size_t nodes = 21;
    const double time_step = 0.1 * 2 / nmbcgen::maximum_frequency(h);
    nmbc::Chain chain(nmbc::make_lattice(table, boundary.G),
                      nmbc::MatchingEnd{{nmbc::evaluate(table.c, boundary.G),
                                         nmbc::evaluate(table.b, boundary.G), 1}},
                      {.nodes = nodes, .time_step = time_step});

    constexpr double disturbance = 1e-3;  // of the outermost ghosts
    std::ranges::fill(chain.displacement(), 1.0);
    chain.displacement().front() += disturbance;
    chain.displacement().back() += disturbance;

    const nmbcgen::LatticeEnd end{nmbcgen::LatticeEnd::Kind::matching, h};
    const auto map = nmbcgen::one_step_map(end, end, nodes, time_step);
    const Eigen::MatrixXd difference = map - Eigen::MatrixXd::Identity(map.rows(), map.cols());
    const Eigen::MatrixXd left = Eigen::FullPivLU<Eigen::MatrixXd>(difference.transpose())
                                     .setThreshold(1e-9)  // roundings; the next is above 1e-6
                                     .kernel();
    REQUIRE(left.cols() == 2);
    const auto all = Eigen::Index(chain.nodes());
    Eigen::VectorXd parabola = Eigen::VectorXd::Constant(map.cols(), -time_step / 2);
    for (Eigen::Index i = 0; i < all; ++i) {
        parabola(i) = std::pow(double(i) - double(all - 1) / 2, 2) / 2;
    }
    const Eigen::VectorXd of_parabola = left.transpose() * parabola;
    const Eigen::VectorXd of_start =
        disturbance * (left.row(0) + left.row(all - 1)).transpose();  // the constant has none
    const double share = of_parabola.dot(of_start) / of_parabola.squaredNorm();

    std::vector<double> growth;
    for (const double time : {1000.0, 2000.0}) {
        while (chain.time() < time) {
            chain.step();
        }
        growth.push_back(chain.displacement()[chain.nodes() / 2] - 1);
        CHECK(growth.back() == relative(share * time * time / 2, tolerance));
    }
    CHECK(growth[1] / growth[0] == relative(4, tolerance));
}

}  // namespace
