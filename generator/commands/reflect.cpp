// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/reflect.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "generator/exact/rational.hpp"
#include "generator/stability/band_reflection.hpp"

namespace nmbcgen {

std::string reflection_csv(const Table& table, unsigned samples) {
    const Specification& what = table.specification;
    const HalfSpace half_space =
        stepped(make_half_space(table, *what.stabilisation), nearest_double(what.time_step));
    std::string csv =
        "omega,incident_xi,outgoing_k_re,outgoing_k_im,amplitude_re,amplitude_im,energy_flux\n";
    for (unsigned i = 0; i < samples; ++i) {
        const double xi = std::numbers::pi * (i + 0.5) / samples;
        const ReflectedWave wave = reflected_wave(half_space, xi);
        const std::vector<Mode>& outgoing = wave.reflection.outgoing;
        const double omega = std::sqrt(omega_squared(half_space, xi));
        const double incident_xi = -std::arg(outgoing[std::size_t(wave.incident)].k);
        for (std::size_t o = 0; o < outgoing.size(); ++o) {
            const std::complex<double> amplitude =
                wave.reflection.amplitudes(Eigen::Index(o), wave.incident);
            csv += fmt::format("{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g}\n", omega,
                               incident_xi, outgoing[o].k.real(), outgoing[o].k.imag(),
                               amplitude.real(), amplitude.imag(), wave.energy_flux[o]);
        }
    }
    return csv;
}

}  // namespace nmbcgen
