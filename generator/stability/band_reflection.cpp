// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/stability/band_reflection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "generator/stability/reflection.hpp"

namespace nmbcgen {
namespace {

/// d omega / d xi, undamped, of a wave of this wave number.
double group_velocity(const HalfSpace& h, double xi) {
    return omega_squared_slope(h, xi) / (2 * std::sqrt(omega_squared(h, xi)));
}

}  // namespace

double reflected_energy(const HalfSpace& half_space, double xi) {
    const Reflection found = reflection(half_space, std::sqrt(omega_squared(half_space, xi)));
    const auto wave = [&found](Eigen::Index index) { return found.outgoing[std::size_t(index)].k; };
    // The incident wave is the mirror image of an outgoing one.
    Eigen::Index incident = 0;
    const auto distance = [&](Eigen::Index column) {
        return std::abs(std::polar(1.0, xi) - wave(column)) *
               std::abs(std::polar(1.0, -xi) - wave(column));
    };
    for (Eigen::Index column = 1; column < found.matrix.cols(); ++column) {
        if (distance(column) < distance(incident)) {
            incident = column;
        }
    }
    if (!half_space.is_damped()) {
        return found.matrix.col(incident).squaredNorm();
    }
    double sum = 0;
    for (Eigen::Index o = 0; o < found.matrix.rows(); ++o) {
        constexpr double fades_little = 0.9;
        if (std::abs(wave(o)) > fades_little) {
            sum += std::norm(found.matrix(o, incident)) *
                   std::abs(group_velocity(half_space, std::arg(wave(o))) /
                            group_velocity(half_space, xi));
        }
    }
    return sum;
}

double mean_reflected_energy(const HalfSpace& half_space, double low, double high) {
    constexpr int samples = 64;
    double sum = 0;
    for (int i = 0; i < samples; ++i) {
        sum += reflected_energy(half_space, low + (high - low) * (i + 0.5) / samples);
    }
    return sum / samples;
}

double loss_per_wavelength(const HalfSpace& half_space, double wavelength) {
    if (!half_space.is_damped()) {
        return 0;
    }
    const double xi = 2 * std::numbers::pi / wavelength;
    double damping = half_space.damping[0];
    for (std::size_t m = 1; m < half_space.damping.size(); ++m) {
        damping += 2 * half_space.damping[m] * std::cos(double(m) * xi);
    }
    // The energy falls at the rate tau sigma, and travels at the group velocity.
    return 1 - std::exp(-damping * wavelength / group_velocity(half_space, xi));
}

}  // namespace nmbcgen
