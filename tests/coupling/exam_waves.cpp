// SPDX-License-Identifier: MIT
/// Waves over a junction of two bars: what it should reflect, and what it does in time.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <nmbc/boundary.hpp>
#include <stdexcept>

#include "generator/coupling/assembly.hpp"
#include "generator/coupling/packet.hpp"
#include "generator/dense/decompositions.hpp"

using namespace nmbcgen;
using enum CouplingForm;

namespace {

const Halves nonlocal_to_local{1, 1, {1, 3}, {1, 0}};
/// NMBC2 of nearest neighbours (chain1d).
const nmbc::BoundaryCoefficients nmbc2{.c = {1, 6, 1}, .b = {-4, 0, 4}};

/// |R|^2 of it, of a wave with frequency omega in steps dt, dX = c = 1: -Delta(1/k)/Delta(k).
double sent_back(double omega, double dt) {
    const std::complex<double> k = std::polar(1.0, 2 * std::asin(omega / 2));
    const std::complex<double> s(0, omega / std::sqrt(1 - omega * omega * dt * dt / 4));
    const auto delta = [&s](std::complex<double> z) {
        return s * (1.0 + 6.0 * z + z * z) - (4.0 * z * z - 4.0);
    };
    const double one_way = std::norm(delta(k) / delta(1.0 / k));
    return std::min(one_way, 1 / one_way);
}

}  // namespace

TEST_CASE("nothing is reflected where nothing changes") {
    const Junction junction({1, 1, {1, 2}, {1, 2}}, pairs);
    for (const double xi : {.1, .5, 1.0}) {
        const Scattering wave = junction.from_left(xi);
        CHECK(wave.reflected < 1e-25);
        CHECK(wave.transmitted == doctest::Approx(1).epsilon(1e-12));
    }
}

TEST_CASE("two local bars: the impedances, with masses on the nodes") {
    // k = 4 on the right: Z = sqrt(rho E cos^2) of a wave whose nodes are h apart.
    const Junction junction({1, 1, {1, 0}, {4, 0}}, pairs);
    for (const double xi : {.01, .4, 1.0}) {
        const double other = 2 * std::asin(std::sin(xi / 2) / 2);
        const double left = std::cos(xi / 2);
        const double right = 2 * std::cos(other / 2);
        const double R = (left - right) / (left + right);
        CHECK(junction.from_left(xi).reflected == doctest::Approx(R * R).epsilon(1e-10));
    }
}

TEST_CASE("pairs keep the energy of every wave") {
    for (const Halves& halves :
         {nonlocal_to_local, Halves{1, 1, {1, Rational(3, 2)}, {1, Rational(3, 4)}},
          Halves{1, 2, {1, Rational(3, 2)}, {1, Rational(3, 2)}},
          Halves{1, Rational(2, 3), {2, 2}, {1, 1}}}) {
        const Junction junction(halves, pairs);
        for (const double xi : {.1, .3, .5, .8}) {
            const Scattering wave = junction.from_left(xi);
            CHECK(wave.reflected + wave.transmitted == doctest::Approx(1).epsilon(1e-11));
        }
    }
    // Above the band of the other bar all of it comes back.
    CHECK(Junction({1, 4, {1, 0}, {1, 0}}, pairs).from_left(.6).reflected ==
          doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE("rows reflect less, and make or lose energy") {
    const Scattering by_pairs = Junction(nonlocal_to_local, pairs).from_left(.5);
    const Scattering by_rows = Junction(nonlocal_to_local, rows).from_left(.5);
    CHECK(by_pairs.reflected == doctest::Approx(.0962711).epsilon(1e-5));
    CHECK(by_rows.reflected == doctest::Approx(1.51547e-4).scale(0).epsilon(1e-5));
    CHECK(by_rows.reflected + by_rows.transmitted == doctest::Approx(1.2112).epsilon(1e-4));
}

TEST_CASE("a packet in time reflects what its waves should, and NMBC2 lets out the rest") {
    const Packet packet{.middle = .5, .width = 24};
    for (const CouplingForm form : {pairs, rows}) {
        const Junction junction(nonlocal_to_local, form);
        const PacketResult measured = run_packet(nonlocal_to_local, form, packet, &nmbc2);
        const double reflected =
            packet.mean([&](double xi) { return junction.from_left(xi).reflected; });
        const double transmitted =
            packet.mean([&](double xi) { return junction.from_left(xi).transmitted; });
        CHECK(measured.reflected == doctest::Approx(reflected).scale(0).epsilon(1e-5));
        CHECK(measured.transmitted == doctest::Approx(transmitted).epsilon(1e-6));
        const LateralChain chain = bar_chain(1, nonlocal_to_local.left);
        const double dt = packet_time_step(nonlocal_to_local, form);
        const Junction back({1, 1, nonlocal_to_local.right, nonlocal_to_local.left}, form);
        const double from_end = packet.mean([&](double xi) {
            const double omega = std::sqrt(omega_squared(chain, xi));
            return junction.from_left(xi).transmitted * sent_back(omega, dt) *
                   back.from_left(2 * std::asin(omega / 2)).transmitted;
        });
        CHECK(measured.from_end == doctest::Approx(from_end).scale(0).epsilon(2e-3));
    }
}

TEST_CASE("an NMBC behind the local part: stable beside pairs, growing beside rows") {
    constexpr Eigen::Index nodes = 61;
    const auto radius = [](CouplingForm form) {
        const double dt = packet_time_step(nonlocal_to_local, form);
        const Mesh mesh = mesh_of(nonlocal_to_local, 30, 30);
        const Eigen::MatrixXd K = stiffness_of(mesh, form);
        const Eigen::MatrixXd A = masses_of(mesh).cwiseInverse().asDiagonal() * K;
        const nmbc::MatchingBoundary end(
            nmbc2, {.ghost_layers = 1, .wave_speed = 1, .spacing = 1, .time_step = dt});
        Eigen::MatrixXd step(2 * nodes, 2 * nodes);
        for (Eigen::Index j = 0; j < 2 * nodes; ++j) {
            Eigen::VectorXd state = Eigen::VectorXd::Unit(2 * nodes, j);
            Eigen::VectorXd u = state.head(nodes);
            Eigen::VectorXd v = state.tail(nodes) - dt * (A * u);
            end.update({u.data(), nodes}, {v.data(), nodes}, nmbc::End::right);
            u += dt * v;
            step.col(j) << u, v;
        }
        return eigenvalues(step).cwiseAbs().maxCoeff();
    };
    CHECK(radius(pairs) < 1 + 1e-13);
    CHECK(radius(rows) == doctest::Approx(1 + 2.86e-5).epsilon(1e-6));
}
