// SPDX-License-Identifier: MIT
/// Whether the two ends of a scene are stable together.
#pragma once

#include <nmbc/table.hpp>
#include <string>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// How a chain between the scene's ends can grow at some length, in words with wave number and rate
/// or amplification; empty where round_trip_verdict() certifies that it does not, in steps
/// of time_step [time]. Of a damped lattice: at the scene's own length.
/// left, right: the tables of the ends, of which only the lattice counts where an end is fixed or
/// free. Their coefficients exist at the scene's G.
/// Opposite an end from which nothing comes back (is_half_line()) an nmbc needs to have no growing
/// mode and no resonance of its own; opposite a sponge or pml, the certificate of its table for any
/// end that adds no energy (nmbc::Opposite::any).
std::string objection(const Scene& scene, const nmbc::MatchingTable& left,
                      const nmbc::MatchingTable& right, double time_step, double cfl);

}  // namespace nmbcrun
