// SPDX-License-Identifier: GPL-2.0-or-later
/// Waves over the junction of two bars: what it should reflect, and what a packet does in time.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "generator/coupling/packet.hpp"

namespace nmbcgen {

/// A number or, where waves cannot be told, NaN.
struct JunctionWaves {
    Halves halves;
    struct Row {
        double xi;                        ///< [1/h of the left bar]
        std::array<Scattering, 2> parts;  ///< by CouplingForm
    };
    std::vector<Row> rows;

    Packet packet;
    struct InTime {
        PacketResult measured;
        PacketResult predicted;
    };
    std::array<InTime, 2> in_time;  ///< by CouplingForm
};

/// The right bar, where it is local, has NMBC2 of nearest neighbours behind it in one more run of
/// the packet.
JunctionWaves waves_over(const Halves& halves);

std::string waves_text(const JunctionWaves& waves);
std::string waves_json(const JunctionWaves& waves);

}  // namespace nmbcgen
