// SPDX-License-Identifier: MIT
/// Stability of chains of a damped lattice. Every wave fades on its way, so what a boundary sends
/// back too strongly may be gone when it arrives at the other end: a chain is stable from some
/// length on (reflection.hpp, damped_round_trip_supremum). Waves that decay from an end count like
/// all others, so short chains need no exception here.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "generator/stability/band_search.hpp"
#include "generator/stability/half_space.hpp"

namespace nmbcgen {

/// Whether leapfrog is stable in the interior: omega^2 dt^2/4 + tau sigma dt/2 <= 1 for every wave.
bool interior_is_stable(const HalfSpace& half_space);

/// The largest amplification of a round trip between two ends of one damped lattice in a chain of
/// so many interior nodes, and its frequency, from 1e-5 of the band's top on. Below, long waves
/// leave but for a part of the order omega^2; and at G = 0, where short waves creep at the
/// zero-energy modes, what they gain at an end and what they lose on the way both go with
/// sqrt(omega), so that what holds there holds below. The search ends at the first value above
/// `enough`. critical: critical_frequencies() of both ends, ascending.
Peak damped_amplification(const HalfSpace& left, const HalfSpace& right,
                          const std::vector<double>& critical, std::size_t nodes,
                          double enough = std::numeric_limits<double>::infinity());

/// Likewise, of like ends.
Peak damped_amplification(const HalfSpace& both, std::size_t nodes);

}  // namespace nmbcgen
