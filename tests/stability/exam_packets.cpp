// SPDX-License-Identifier: GPL-2.0-or-later
/// Narrow-band packets: the runtime's boundaries reflect the energy that reflection() says.
///
/// A boundary is linear and does not change with time, so waves of different frequency are
/// reflected each on its own; and at one frequency the energy fluxes of different travelling waves
/// add up. Of a packet of incident waves with the energy spectrum e(xi) the reflected fraction is
/// therefore the mean of sum_o |R_oi(xi)|^2 over e, however wide the packet.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nmbc/ends.hpp>
#include <nmbc/energy.hpp>
#include <numbers>
#include <vector>

#include "generator/stability/discrete.hpp"
#include "generator/stability/reflection.hpp"
#include "tests/stability/boundary.hpp"

namespace {

using nmbcgen::HalfSpace;
using nmbcgen::test::Boundary;
using nmbcgen::test::relative;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double width = 30;         ///< sigma of the envelope exp(-x^2 / 2 sigma^2) [dX]
constexpr double reach = 6 * width;  ///< of the envelope; beyond it is below 1.6e-8 and left out

/// One wave of a packet, Re amplitude exp i(xi x + omega' t), xi signed so that it travels to the
/// left. Leapfrog turns omega, the lattice's frequency at xi, into omega', of which
/// sin(omega' dt/2) = omega dt/2.
struct Wave {
    double xi;
    double amplitude;
    double omega;
    double half_angle;  ///< omega' dt/2

    /// Up to a common factor. The cosine is from u at k and k+1 in the potential energy.
    double energy() const { return std::pow(amplitude * omega * std::cos(half_angle), 2); }
};

double group_velocity(const HalfSpace& h, double xi) {
    return nmbcgen::omega_squared_slope(h, xi) / (2 * std::sqrt(nmbcgen::omega_squared(h, xi)));
}

/// The wave numbers of a packet: steps of 1/(4 sigma), so that its periodic images are 8 pi sigma
/// away, to 6/sigma on both sides.
std::vector<double> spectrum(double middle) {
    constexpr int half_count = 24;
    std::vector<double> xis;
    for (int m = -half_count; m <= half_count; ++m) {
        xis.push_back(middle + m / (4 * width));
    }
    return xis;
}

/// The Gaussian packet about xi > 0 in the time steps of h.
std::vector<Wave> make_packet(const HalfSpace& h, double xi) {
    const double leftwards = group_velocity(h, xi) > 0 ? 1 : -1;
    std::vector<Wave> packet;
    for (const double each : spectrum(xi)) {
        const double omega = std::sqrt(nmbcgen::omega_squared(h, each));
        packet.push_back({leftwards * each, std::exp(-std::pow((each - xi) * width, 2) / 2), omega,
                          std::asin(omega * h.time_step / 2)});
    }
    return packet;
}

struct Prediction {
    double reflected = 0;        ///< fraction of the incident energy
    double scalar = 0;           ///< the same by the paper's |R|^2
    double slowest = infinity;   ///< group velocity among the incident waves [c]
    double fastest = 0;          ///< and among the reflected ones
    std::size_t travelling = 0;  ///< waves at one frequency, at most
};

Prediction predict(const HalfSpace& h, const std::vector<Wave>& packet) {
    Prediction result;
    double total = 0;
    for (const Wave& wave : packet) {
        const auto R = nmbcgen::reflection(h, wave.omega);
        const auto mirrored = std::polar(1.0, -wave.xi);
        const auto distance = [&](const nmbcgen::Mode& mode) {
            return mode.travels() ? std::abs(mode.k - mirrored) : infinity;
        };
        const auto incident = std::ranges::min_element(R.outgoing, {}, distance);
        result.reflected +=
            wave.energy() * R.matrix.col(incident - R.outgoing.begin()).squaredNorm();
        result.scalar += wave.energy() * std::norm(nmbcgen::scalar_reflection(h, wave.xi));
        total += wave.energy();
        // Steps divide all group velocities at one omega by the same cosine; their ratios stay.
        const double cosine = std::cos(wave.half_angle);
        result.slowest = std::min(result.slowest, incident->group_velocity / cosine);
        for (const nmbcgen::Mode& mode : R.outgoing) {
            result.fastest = std::max(result.fastest, mode.group_velocity / cosine);
        }
        result.travelling = std::max(result.travelling, std::size_t(R.matrix.rows()));
    }
    result.reflected /= total;
    result.scalar /= total;
    return result;
}

/// The fraction of its energy that is left when the packet has met the left end. The chain is so
/// long that the fastest reflected wave has not reached its other end when the slowest incident one
/// has met this end.
double measure(const Boundary& boundary, const HalfSpace& h, double xi) {
    const auto packet = make_packet(h, xi);
    const Prediction speeds = predict(h, packet);
    const double duration = 2 * reach / speeds.slowest;
    const auto& table = nmbcgen::test::committed_table(boundary);
    nmbc::Chain chain(
        nmbc::make_lattice(table, boundary.G),
        nmbc::MatchingEnd{nmbc::boundary_coefficients(table, boundary.G)},
        {.nodes = std::size_t(2 * reach + speeds.fastest * duration), .time_step = h.time_step});
    for (std::size_t i = 0; i <= std::size_t(2 * reach); ++i) {
        for (const Wave& wave : packet) {
            const double phase = wave.xi * (double(i) - reach);
            chain.displacement()[chain.ghosts() + i] += wave.amplitude * std::cos(phase);
            chain.velocity()[chain.ghosts() + i] -=
                wave.amplitude * wave.omega * std::sin(phase - wave.half_angle);
        }
    }
    const double before = nmbc::energies(chain).staggered;
    while (chain.time() < duration) {
        chain.step();
    }
    return nmbc::energies(chain).staggered / before;
}

/// Ten wave numbers, evenly through the part of the band in which no wave of a packet is slower
/// than c/10: slow packets need long chains.
std::vector<double> ten_wave_numbers(const HalfSpace& h) {
    std::vector<double> usable;
    for (int i = 1; i < 1000; ++i) {
        const double middle = i * std::numbers::pi / 1000;
        const bool fast = std::ranges::all_of(spectrum(middle), [&h](double xi) {
            return xi > 0 && xi < std::numbers::pi && std::abs(group_velocity(h, xi)) > 0.1;
        });
        if (fast) {
            usable.push_back(middle);
        }
    }
    std::vector<double> chosen;
    for (std::size_t i = 0; i < 10; ++i) {
        chosen.push_back(usable[(2 * i + 1) * usable.size() / 20]);
    }
    return chosen;
}

HalfSpace at_cfl(double cfl, const HalfSpace& h) {
    return stepped(h, cfl * 2 / nmbcgen::maximum_frequency(h));
}

const std::vector<Boundary> certified{{1, 1, 1, 0.5}, {1, 2, 1, 0.5}, {1, 3, 1, 0.5},
                                      {2, 1, 1, 1},   {2, 2, 2, 1},   {3, 2, 3, 2}};

TEST_CASE("stepped by leapfrog, packets are reflected as predicted at its frequencies") {
    for (const Boundary& boundary : certified) {
        CAPTURE(boundary.horizon);
        CAPTURE(boundary.order);
        const auto h = at_cfl(0.4, half_space(boundary));
        for (const double xi : ten_wave_numbers(h)) {
            CAPTURE(xi);
            const double predicted = predict(h, make_packet(h, xi)).reflected;
            const double measured = measure(boundary, h, xi);
            // 1e-10 was found, but for packets in whose spectrum another wave begins to travel,
            // with a root of omega there that 49 wave numbers integrate to 5e-4. The envelope's
            // ends are 2e-16 of the energy.
            CHECK(std::abs(measured - predicted) < std::max(1e-3 * predicted, 1e-14));
        }
    }
}

/// One packet for each table, where so much is reflected that leapfrog's own error, 1e-5 in R at
/// this cfl, is small beside it: 1.5 % of |R|^2 at most was found, of the 3 % the project asks for.
/// (At longer waves the step decides: what NMBC3 at n = 1 reflects of xi = 0.33 is 1e-13 in
/// continuous time and 1e-6 at cfl 0.4.)
TEST_CASE("with small time steps, packets are reflected as predicted in continuous time") {
    std::size_t several = 0;
    for (const Boundary& boundary : certified) {
        CAPTURE(boundary.horizon);
        CAPTURE(boundary.order);
        const auto h = half_space(boundary);
        const double xi = ten_wave_numbers(h)[7];
        const Prediction prediction = predict(h, make_packet(h, xi));
        const double measured = measure(boundary, at_cfl(0.04, h), xi);
        CHECK(measured == relative(prediction.reflected, 0.03));
        if (prediction.travelling == 1) {
            CHECK(prediction.scalar == relative(prediction.reflected, 1e-12));
        } else {
            ++several;
            // The paper's |R|^2 knows nothing of the other waves and their energy fluxes.
            CHECK(measured != relative(prediction.scalar, 0.1));
        }
    }
    CHECK(several == 3);
}

}  // namespace
