// SPDX-License-Identifier: MIT
#include "generator/stability/band_reflection.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

namespace nmbcgen {
namespace {

/// d omega / d xi, undamped, of a wave of this wave number.
double group_velocity(const HalfSpace& h, double xi) {
    return omega_squared_slope(h, xi) / (2 * std::sqrt(omega_squared(h, xi)));
}

}  // namespace

ReflectedWave reflected_wave(const HalfSpace& half_space, double xi) {
    ReflectedWave wave{
        .reflection = reflection(half_space, std::sqrt(omega_squared(half_space, xi))),
        .incident = 0,
        .energy_flux = {}};
    const std::vector<Mode>& outgoing = wave.reflection.outgoing;
    const Eigen::MatrixXcd& R = wave.reflection.matrix;
    // The incident wave is the mirror image of an outgoing one.
    const auto distance = [&](Eigen::Index column) {
        const std::complex<double> k = outgoing[std::size_t(column)].k;
        return std::abs(std::polar(1.0, xi) - k) * std::abs(std::polar(1.0, -xi) - k);
    };
    for (Eigen::Index column = 1; column < R.cols(); ++column) {
        if (distance(column) < distance(wave.incident)) {
            wave.incident = column;
        }
    }
    for (std::size_t o = 0; o < outgoing.size(); ++o) {
        const auto row = Eigen::Index(o);
        double flux = row < R.rows() ? std::norm(R(row, wave.incident)) : 0;
        if (half_space.is_damped()) {
            constexpr double fades_little = 0.9;
            const std::complex<double> k = outgoing[o].k;
            flux = std::abs(k) > fades_little
                       ? flux * std::abs(group_velocity(half_space, std::arg(k)) /
                                         group_velocity(half_space, xi))
                       : 0;
        }
        wave.energy_flux.push_back(flux);
    }
    return wave;
}

double reflected_energy(const HalfSpace& half_space, double xi) {
    const std::vector<double> flux = reflected_wave(half_space, xi).energy_flux;
    return std::accumulate(flux.begin(), flux.end(), 0.0);
}

std::vector<double> reflected_energies(const HalfSpace& half_space, double low, double high) {
    constexpr int samples = 64;
    std::vector<double> energies;
    energies.reserve(samples);
    for (int i = 0; i < samples; ++i) {
        energies.push_back(reflected_energy(half_space, low + (high - low) * (i + 0.5) / samples));
    }
    return energies;
}

double mean_reflected_energy(const HalfSpace& half_space, double low, double high) {
    const std::vector<double> energies = reflected_energies(half_space, low, high);
    return std::accumulate(energies.begin(), energies.end(), 0.0) / double(energies.size());
}

double loss_per_wavelength(const HalfSpace& half_space, double wavelength) {
    if (!half_space.is_damped()) {
        return 0;
    }
    const double xi = 2 * std::numbers::pi / wavelength;
    // The energy falls at the rate tau sigma, and travels at the group velocity.
    const double rate = symbol_at(half_space.damping, xi);
    return 1 - std::exp(-rate * wavelength / std::abs(group_velocity(half_space, xi)));
}

}  // namespace nmbcgen
