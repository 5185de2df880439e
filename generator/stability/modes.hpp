// SPDX-License-Identifier: MIT
/// Waves of the lattice at one frequency: the roots k of its dispersion relation, and their group
/// velocities.
#pragma once

#include <complex>
#include <vector>

#include "generator/stability/half_space.hpp"
#include "generator/stability/level_roots.hpp"

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

/// Likewise, at many frequencies, in less time: in an undamped lattice omega^2 is cut at its
/// extrema once, in a damped one each frequency begins from the modes of the one before.
class OutgoingModes {
  public:
    /// The half space has to stay where it is; its time step may change.
    explicit OutgoingModes(const HalfSpace& half_space);
    explicit OutgoingModes(const HalfSpace&& half_space) = delete;

    std::vector<Mode> at(double omega);

  private:
    const HalfSpace& half_space_;
    LevelRoots undamped_;                         ///< where omega^2, of x = cos xi, has a value
    std::vector<std::complex<double>> damped_{};  ///< x of the frequency before
};

/// The one that decays least on its way, which brings most of what comes back.
const Mode& least_fading(const std::vector<Mode>& modes);

}  // namespace nmbcgen
