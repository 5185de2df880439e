// SPDX-License-Identifier: GPL-2.0-or-later
#include "tools/stability_atlas/rays.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "generator/stability/band_reflection.hpp"

namespace stability_atlas {

using nmbcgen::HalfSpace;

namespace {

double frequency(const HalfSpace& h, double xi) {
    return std::sqrt(omega_squared(h, xi));
}

/// cos(omega' dt/2), omega' the frequency in steps, sin(omega' dt/2) = omega dt/2.
double step_cosine(const HalfSpace& h, double xi) {
    const double sine = frequency(h, xi) * h.time_step / 2;
    return std::sqrt(1 - sine * sine);
}

/// Either way, in time steps.
double speed(const HalfSpace& h, double xi) {
    return std::abs(omega_squared_slope(h, xi)) / (2 * frequency(h, xi) * step_cosine(h, xi));
}

/// What damping leaves of the energy after a time: the roots zeta of a step have the product
/// 1 - dt tau sigma, which is |zeta|^2.
double kept(const HalfSpace& h, double xi, double time) {
    if (!h.is_damped()) {
        return 1;
    }
    const double step_loss = h.time_step * nmbcgen::symbol_at(h.damping, xi);
    return step_loss < 1 ? std::exp(std::log1p(-step_loss) * time / h.time_step) : 0;
}

constexpr double lost = 1e-45;  // far below what a run of doubles can show

/// Of a wave that has this far to go to the end, and is this part of the one at the start. Each
/// reflection may make several: without an end to it they would be without number.
double left_of(const HalfSpace& h, double xi, double distance, double length, double time,
               double part) {
    if (part < lost) {
        return 0;
    }
    const double arrival = distance / speed(h, xi);
    if (!(arrival < time)) {
        return kept(h, xi, time);
    }
    const nmbcgen::ReflectedWave wave = nmbcgen::reflected_wave(h, xi);
    const double arriving = kept(h, xi, arrival);
    double sum = 0;
    for (std::size_t o = 0; o < wave.energy_flux.size(); ++o) {
        if (wave.energy_flux[o] > 0) {
            const double outgoing = std::abs(std::arg(wave.reflection.outgoing[o].k));
            sum += wave.energy_flux[o] * left_of(h, outgoing, length, length, time - arrival,
                                                 part * arriving * wave.energy_flux[o]);
        }
    }
    return arriving * sum;
}

}  // namespace

std::vector<Ray> trace(const HalfSpace& half_space, const Course& course, int samples) {
    std::vector<Ray> rays;
    for (int i = 0; i < samples; ++i) {
        const double xi = std::numbers::pi * (i + 0.5) / samples;
        const double distance = course.length / 2;
        const bool there = distance < speed(half_space, xi) * course.duration;
        const double left = left_of(half_space, xi, distance, course.length, course.duration, 1);
        rays.push_back({xi, left, there ? 0 : left});
    }
    return rays;
}

Prediction predict(const HalfSpace& half_space, const std::vector<Ray>& rays, double half_width) {
    Prediction sum;
    double start = 0;
    for (const Ray& ray : rays) {
        // omega^2 times the square of the pulse's transform. The kinetic energy is of k - 1/2, the
        // potential one of the mean of u at k - 1 and k, a factor of the cosine: of a standing wave
        // at the start, half a step before its crest, and of two travelling ones at the end.
        const double power =
            omega_squared(half_space, ray.xi) * std::exp(-std::pow(ray.xi * half_width, 2) / 2);
        const double cosine = std::pow(step_cosine(half_space, ray.xi), 2);
        const double travelling = power * (1 + cosine) / 2;
        start += power * (1 - cosine + cosine * cosine);
        sum.left += travelling * ray.left;
        sum.not_yet_there += travelling * ray.not_yet_there;
    }
    return {sum.left / start, sum.not_yet_there / start};
}

}  // namespace stability_atlas
