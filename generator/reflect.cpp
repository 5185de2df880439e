// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/reflect.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "generator/stability/reflection.hpp"

namespace nmbcgen {

std::string reflection_csv(const Table& table, unsigned samples) {
    const HalfSpace half_space = make_half_space(table, *table.specification.stabilisation);
    std::string csv =
        "omega,incident_xi,outgoing_k_re,outgoing_k_im,amplitude_re,amplitude_im,energy_flux\n";
    for (unsigned i = 0; i < samples; ++i) {
        const double xi = std::numbers::pi * (i + 0.5) / samples;
        const double omega = std::sqrt(omega_squared(half_space, xi));
        const Reflection found = reflection(half_space, omega);
        // The incident wave is the mirror image of the outgoing one of the same |xi|.
        Eigen::Index incident = 0;
        const auto distance = [&](Eigen::Index column) {
            return std::abs(std::abs(std::arg(found.outgoing[std::size_t(column)].k)) - xi);
        };
        for (Eigen::Index column = 1; column < found.matrix.cols(); ++column) {
            if (distance(column) < distance(incident)) {
                incident = column;
            }
        }
        const double incident_xi = -std::arg(found.outgoing[std::size_t(incident)].k);
        for (std::size_t o = 0; o < found.outgoing.size(); ++o) {
            const auto row = Eigen::Index(o);
            const std::complex<double> amplitude = found.amplitudes(row, incident);
            const double flux =
                row < found.matrix.rows() ? std::norm(found.matrix(row, incident)) : 0;
            csv += fmt::format("{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g}\n", omega,
                               incident_xi, found.outgoing[o].k.real(), found.outgoing[o].k.imag(),
                               amplitude.real(), amplitude.imag(), flux);
        }
    }
    return csv;
}

}  // namespace nmbcgen
