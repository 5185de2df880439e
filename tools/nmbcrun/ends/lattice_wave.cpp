// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/ends/lattice_wave.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nmbcrun {
namespace {

using std::numbers::pi;

/// Of the transform of f at whole numbers: wave numbers 2 pi apart are one there.
std::complex<double> folded(const Transform& transform, double xi) {
    std::complex<double> sum = 0;
    const auto turns = long(std::ceil((transform.highest + pi) / (2 * pi)));
    for (long turn = -turns; turn <= turns; ++turn) {
        const double each = xi + 2 * pi * double(turn);
        if (std::abs(each) <= transform.highest) {
            sum += transform.value(each);
        }
    }
    return sum;
}

/// zeta - 1 = y, of y^2 + (A + B) y + A = 0, A = (dt omega)^2, B = dt tau sigma; `sign` is that of
/// the frequency.
std::complex<double> change_of(double A, double B, int sign) {
    const double sum = A + B;
    const double square = 4 * A - sum * sum;
    if (square < 0) {
        return (std::sqrt(-square) - sum) / 2;  // of two that decay, the one that stays longer
    }
    return {-sum / 2, -sign * std::sqrt(square) / 2};
}

}  // namespace

std::vector<LatticeWave> one_way_waves(const Transform& transform, std::size_t period,
                                       nmbc::End towards, const nmbc::Lattice& lattice,
                                       const nmbc::ChainParameters& parameters) {
    const double rate = parameters.wave_speed() / parameters.spacing;
    const double courant = rate * parameters.time_step;
    const int right = towards == nmbc::End::right ? 1 : -1;
    std::vector<LatticeWave> waves;
    double largest = 0;
    for (std::size_t q = 0; 2 * q <= period; ++q) {
        const double xi = 2 * pi * double(q) / double(period);
        if (xi > transform.highest && transform.highest < pi) {
            break;
        }
        // +xi and -xi are one wave, where they differ.
        const double share = (q == 0 || 2 * q == period ? 1.0 : 2.0) / double(period);
        const std::complex<double> amplitude = share * folded(transform, xi);
        largest = std::max(largest, std::abs(amplitude));
        // At xi = 0 it is 0 up to roundings, of either sign.
        const double square = q == 0 ? 0 : std::max(omega_squared(lattice, xi), 0.0);
        const double damping =
            lattice.damping.empty() || q == 0 ? 0 : nmbc::detail::symbol_at(lattice.damping, xi);
        const double A = courant * courant * square;
        const double steepness = nmbc::omega_squared_slope(lattice, xi);
        const int sign = steepness < 0 ? -right : right;
        const double cosine = std::sqrt(std::max(1 - A / 4, 0.0));  // of omega_d dt/2
        const double speed = 2 * std::sqrt(square) * cosine;
        const double velocity =
            q == 0 ? rate : (speed > 0 ? std::abs(steepness) / speed * rate : 0.0);
        waves.push_back({amplitude, xi, change_of(A, courant * damping, sign), right * velocity});
    }
    std::erase_if(waves, [&](const LatticeWave& wave) {
        constexpr double nothing = 1e-18;
        return std::abs(wave.amplitude) <= nothing * largest;
    });
    return waves;
}

WavesAtNodes::WavesAtNodes(const std::vector<LatticeWave>& waves, double first, double time_step) {
    waves_.reserve(waves.size());
    for (const LatticeWave& wave : waves) {
        const std::complex<double> i(0, 1);
        const double xi = wave.wave_number;
        // log |zeta| without the rounding of 1 + change.
        const double decay = std::log1p(2 * wave.change.real() + std::norm(wave.change)) / 2;
        const double angle = std::atan2(wave.change.imag(), 1 + wave.change.real());
        waves_.push_back({wave.amplitude * std::exp(i * xi * first),
                          std::exp(i * xi),
                          {decay, angle},
                          wave.change / time_step});
    }
}

void WavesAtNodes::add(double k, std::span<double> u, std::span<double> v) const {
    for (const Wave& wave : waves_) {
        std::complex<double> each = wave.first * std::exp(k * wave.log_zeta);
        for (std::size_t node = 0; node < u.size(); ++node) {
            u[node] += each.real();
            v[node] += (each * wave.velocity).real();
            each *= wave.next;
        }
    }
}

}  // namespace nmbcrun
