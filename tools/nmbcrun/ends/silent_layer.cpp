// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/ends/silent_layer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace nmbcrun {

std::size_t silent_layer(const nmbc::Lattice& lattice, double time_step, double duration) {
    constexpr std::size_t samples = 4096;
    constexpr double step = std::numbers::pi / samples;
    // sin(theta/2) = omega dt/2: theta/dt is what leapfrog makes of omega.
    std::vector<double> frequency;
    for (std::size_t i = 0; i <= samples; ++i) {
        const double omega =
            std::sqrt(std::max(nmbc::omega_squared(lattice, double(i) * step), 0.0));
        frequency.push_back(2 / time_step * std::asin(std::min(omega * time_step / 2, 1.0)));
    }
    double fastest = 0;
    double bending = 0;  // of the group velocity over the wave number
    for (std::size_t i = 1; i <= samples; ++i) {
        const double velocity = (frequency[i] - frequency[i - 1]) / step;
        fastest = std::max(fastest, std::abs(velocity));
        if (i < samples) {
            const double next = (frequency[i + 1] - frequency[i]) / step;
            bending = std::max(bending, std::abs(next - velocity) / step);
        }
    }
    // Ahead of the fastest wave the field falls as an Airy function of the distance in units of
    // (|v''| t/2)^(1/3), and v'' is at most reach times v' or so: Ai(12)/Ai(0) = 4e-13.
    const double unit = std::cbrt(double(lattice.reach()) * bending * duration / 2);
    return std::size_t(std::ceil(fastest * duration / 2 + 12 * unit)) + 8 * lattice.reach();
}

}  // namespace nmbcrun
