// SPDX-License-Identifier: MIT
/// What a plane is set up from, has, and goes on from.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nmbc {

/// Physical set-up, in any one consistent system of units.
struct PlaneParameters {
    std::size_t nx = 0;         ///< interior nodes along x
    std::size_t ny = 0;         ///< and along y
    double spacing = 1;         ///< dX [length]
    double youngs_modulus = 1;  ///< E [stress]
    double density = 1;         ///< rho [mass/volume]
    double time_step = 0;       ///< dt [time]

    /// sqrt(E/rho)/dX [1/time]: waves are a little faster than a node per 1/rate.
    double rate() const { return std::sqrt(youngs_modulus / density) / spacing; }
};

/// Energies [per thickness] at t - dt/2, where the velocity is known; the displacement there is the
/// mean of its two neighbours in time.
struct PlaneEnergies {
    double kinetic = 0;
    double strain = 0;         ///< of the stress sigma that belongs to the strain: sigma:e/2
    double stabilisation = 0;  ///< (s/2) sum |z|^2
    /// Kinetic energy plus the potential one, that of the null Lagrangian included, with u^k and
    /// u^{k+1} in its two places: of the whole body, a step lowers it by what leaves through
    /// passive sides and sponges and by what broken bonds had, and by nothing else unless ghosts
    /// move. `total` differs by O(dt^2).
    double staggered = 0;

    double total() const { return kinetic + strain + stabilisation; }
};

/// All that a run goes on from.
template <class Real>
struct PlaneState {
    std::size_t steps = 0;
    std::array<std::vector<Real>, 2> displacement{};
    std::array<std::vector<Real>, 2> velocity{};
    std::vector<Real> ghosts{};          ///< what the conditions of ghosts remember
    std::array<double, 4> gone{};        ///< sums of what left() counts
    std::vector<std::uint32_t> bonds{};  ///< which hold, of a bond-based plane
    double broken = 0;
    double released = 0;  ///< over E
    double damped = 0;    ///< sums of what damped() counts
};

}  // namespace nmbc
