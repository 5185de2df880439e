// SPDX-License-Identifier: MIT
/// What a side of a half plane makes of the waves that come to it, at one frequency and one wave
/// number along the side, in continuous time and without damping.
///
/// Waves are U z^I exp(i omega t), I layers inwards from the innermost ghost layer's neighbour.
/// Those that travel inwards or decay go out from the side; their mirror images (1/z, the normal
/// component reversed) come to it. The conditions on the ghost layers M = 1 .. reach are linear in
/// the amplitudes:
///     sum over outgoing o of A_o [Delta(z_o) U_o] z_o^-M = -[Delta(z_i) U_i] z_i^-M,
/// Delta(z) = residual at D = i omega, Z = z, component by component.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "generator/plane/side_condition.hpp"

namespace nmbcgen {

struct PlaneMode {
    std::complex<double> z;
    Eigen::VectorXcd shape;     ///< of length 1, components as in LateralChain
    double group_velocity = 0;  ///< inwards, normal to the side; 0: it decays

    bool travels() const { return group_velocity != 0; }
};

/// The incident wave that the mirror makes of an outgoing one.
PlaneMode mirror_image(PlaneMode mode);

/// Outgoing modes at a frequency, those that travel first; empty where they cannot be told from the
/// incident ones, as at the edge of a band.
std::vector<PlaneMode> outgoing_plane_modes(const LateralChain& chain, double omega);

/// R between travelling waves: rows outgoing, columns their mirror images, |entry|^2 a fraction of
/// the incident energy flux.
Eigen::MatrixXcd side_reflection(const std::vector<PlaneMode>& outgoing,
                                 const SideCondition& condition, std::size_t reach, double omega);

/// How a side amplifies waves of one frequency and wave number along it.
struct Amplification {
    double alone = 0;  ///< sigma_max(R): of the root of the energy, opposite any passive side
    /// sup over phases of rho(R D): opposite a side alike, however far. With R_D the reflection by
    /// fixed ghost layers, flux-unitary and symmetric, and one Delta for both components,
    ///     R = -Delta_o^-1 R_D Delta_i, so that it is sigma_max(g R_D g), g = sqrt|Delta_i/Delta_o|
    /// (Takagi). Components with conditions of their own: alone, a bound.
    double paired = 0;
};

/// Nothing where modes cannot be told, or R_D is not unitary to 1e-6 in doubles.
std::optional<Amplification> amplification(const LateralChain& chain,
                                           const SideCondition& condition, double omega);

/// The largest of all waves that travel, each with the wave vector (k_x, k_t) [1/dX] of a wave at
/// its frequency.
struct LargestAmplification {
    Amplification value;
    Eigen::Vector2d alone_at = Eigen::Vector2d::Zero();
    Eigen::Vector2d paired_at = Eigen::Vector2d::Zero();
};

/// Sought on samples x samples wave vectors of both branches, and around the largest ones: what is
/// narrower than they are apart may be missed.
LargestAmplification largest_amplification(const PlaneLattice& lattice,
                                           const SideCondition& condition, std::size_t samples);

/// A P or S wave that comes to a side.
struct IncidentWave {
    double omega = 0;
    double wave_number = 0;           ///< k_t [1/dX]
    std::vector<PlaneMode> outgoing;  ///< at these
    Eigen::Index column = 0;          ///< of the wave in reflection matrices
};

/// At an angle from the normal, 0 <= angle < pi/2, with wave number xi > 0 [1/dX] so small that
/// modes are P and S. Where another wave just begins to travel at this frequency, the angle is 1e-4
/// off; throws std::domain_error where modes cannot be told there, either.
IncidentWave incident_wave(const PlaneLattice& lattice, bool is_P, double xi, double angle);

/// The part of its energy that comes back, in any polarisation.
double reflected_in_plane(const IncidentWave& wave, const SideCondition& condition,
                          std::size_t reach);

}  // namespace nmbcgen
