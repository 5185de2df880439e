// SPDX-License-Identifier: MIT
/// The waves that a scene's sources send to its ends.
#pragma once

#include <complex>
#include <cstddef>
#include <nmbc/lattice.hpp>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Waves about one wave number xi, on their way in both directions. Units dX = c = 1; amplitudes
/// are those of Re a exp(i(kappa x - omega t)), |kappa| = xi, x counted from the outermost interior
/// node at the left.
struct WaveBand {
    double xi;                       ///< in (0, pi)
    double omega;                    ///< of the lattice in continuous time
    double speed;                    ///< |group velocity|
    std::complex<double> forwards;   ///< a of kappa = xi
    std::complex<double> backwards;  ///< a of kappa = -xi
    bool is_backward;                ///< energy goes against the phase
};

/// What is under way when the sources have ended, as if there were no ends.
struct Outgoing {
    std::vector<WaveBand> bands;  ///< equal parts of 0 .. pi; none stands still
    double largest = 0;           ///< |u| at any time up to then, what errors are relative to
    double duration = 0;          ///< of the sources [dX/c]
    double remaining = 0;         ///< of the run after them [dX/c]
    /// Interior nodes between the outermost one that moves then and each end.
    std::size_t from_left = 0;
    std::size_t from_right = 0;
};

/// Steps the scene without ends, in steps of this cfl, until its sources have ended.
/// Throws as Simulation does.
Outgoing outgoing_waves(const Scene& scene, double cfl);

/// theta of leapfrog's step for a wave of frequency omega, sin(theta/2) = omega dt/2.
double angle_of_step(double omega, double time_step);

}  // namespace nmbcrun
