// SPDX-License-Identifier: MIT
/// A free Gaussian pulse in a chain, and what is left of its energy.
#pragma once

#include <cstddef>
#include <nmbc/chain.hpp>
#include <nmbc/lattice.hpp>
#include <nmbc/table.hpp>

namespace pulses {

inline constexpr std::size_t counted_nodes = 500;
inline constexpr double end_time = 900;  // [dX/c]

/// Units dX = c = 1. At t = 0, u = exp(-(x/w)^2) about the middle of the chain and v = 0, w the
/// half-width [dX]. Each of these returns the energy at the first step at the end time or after,
/// over that at the start.

/// In the middle counted_nodes of this chain, which is started.
double energy_left(nmbc::Chain& chain, double half_width, double duration = end_time);

/// In a chain of counted_nodes between two ends of this table, certified at G.
double left_between_ends(const nmbc::MatchingTable& table, double G, double time_step,
                         double half_width);

/// In the middle counted_nodes of a chain so long that nothing comes back from an end.
double left_in_long_chain(const nmbc::Lattice& lattice, double time_step, double half_width);

/// The part of its energy that a wave of this length [dX] loses to damping on its way over so many
/// wavelengths; 0 undamped.
double loss(const nmbc::Lattice& lattice, double wavelength, double wavelengths);

}  // namespace pulses
