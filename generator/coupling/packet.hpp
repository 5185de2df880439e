// SPDX-License-Identifier: MIT
/// A packet of waves in time, from a bar on the left over the junction into one on the right.
/// Masses on the nodes, density 1, leapfrog steps.
#pragma once

#include <functional>
#include <nmbc/coefficients.hpp>
#include <vector>

#include "generator/coupling/scattering.hpp"

namespace nmbcgen {

/// Waves exp(-(xi - middle)^2 width^2/2) of the left bar, in units of its element's length.
struct Packet {
    double middle = 0.5;  ///< xi
    double width = 12;    ///< of its envelope exp(-(X/width)^2/2)

    struct Wave {
        double xi;
        double amplitude;
    };
    /// Those with 0 < xi < pi, evenly spaced, within five widths of the middle.
    std::vector<Wave> waves() const;

    /// The mean of a part of the energy over the waves, by their squares.
    double mean(const std::function<double(double xi)>& part) const;
};

/// Parts of sum h u^2 of the packet that arrives: where every wave is far from the junction and
/// goes one way, of its energy at a frequency.
struct PacketResult {
    double reflected = 0;
    double transmitted = 0;
    double from_end = 0;  ///< what an end behind the right bar sends back into the left one
};

/// Half of the longest step, nearly.
double packet_time_step(const Halves& halves, CouplingForm form);

/// end: a matching condition without certificate, for nearest neighbours, some elements behind the
/// junction, where the right bar is local; none: that bar goes on.
PacketResult run_packet(const Halves& halves, CouplingForm form, const Packet& packet,
                        const nmbc::BoundaryCoefficients* end);

}  // namespace nmbcgen
