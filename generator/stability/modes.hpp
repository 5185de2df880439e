// SPDX-License-Identifier: MIT
/// Waves of the lattice at one frequency: the roots k of its dispersion relation, and their group
/// velocities.
#pragma once

#include <complex>
#include <vector>

#include "generator/stability/half_space.hpp"

namespace nmbcgen {

/// A solution u_j = k^j exp(i omega t) of the interior, or in time steps k^j zeta^t.
/// group_velocity: of a travelling wave (|k| = 1), positive inwards; 0 for a wave that decays
/// inwards (|k| < 1), as they all do in a damped lattice.
struct Mode {
    std::complex<double> k;
    double group_velocity = 0;

    bool travels() const { return group_velocity != 0; }
};

/// The waves a boundary can send into the half space at frequency omega > 0: travelling inwards,
/// or decaying inwards; `reach` of them, travelling ones first, by ascending wave number. What
/// comes in are their mirror images, 1/k, one for each that travels, and in a damped lattice one
/// for each.
std::vector<Mode> outgoing_modes(const HalfSpace& half_space, double omega);

/// Likewise, of a damped lattice; nearby: those of a frequency next to it, which save time, or
/// none.
std::vector<Mode> outgoing_modes(const HalfSpace& half_space, double omega,
                                 const std::vector<Mode>& nearby);

/// The one that decays least on its way, which brings most of what comes back.
const Mode& least_fading(const std::vector<Mode>& modes);

}  // namespace nmbcgen
