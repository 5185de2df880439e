// SPDX-License-Identifier: MIT
/// What a side of a half plane makes of the waves that come to it (plane_modes.hpp). The conditions
/// on the ghost layers M = 1 .. reach are linear in the amplitudes:
///     sum over outgoing o of A_o [Delta(z_o) U_o] z_o^-M = -[Delta(z_i) U_i] z_i^-M,
/// Delta(z) = residual at D = i omega, Z = z, component by component. In leapfrog steps
/// (leapfrog.hpp) D is another, and omega is that of the wave in continuous time, below 2/dt; the
/// waves, what fixed ghost layers make of them, and flux but for a factor are those of continuous
/// time.
#pragma once

#include <optional>
#include <vector>

#include "generator/plane/plane_modes.hpp"
#include "generator/plane/side_condition.hpp"

namespace nmbcgen {

/// What the conditions on the ghost layers 1 .. reach have of modes at D = rate, times z^reach: a
/// column each, component by component.
Eigen::MatrixXcd conditions_on(const std::vector<PlaneMode>& modes, const SideCondition& condition,
                               std::size_t reach, std::complex<double> rate);

/// R between travelling waves: rows outgoing, columns their mirror images, |entry|^2 a fraction of
/// the incident energy flux.
Eigen::MatrixXcd side_reflection(const std::vector<PlaneMode>& outgoing,
                                 const SideCondition& condition, std::size_t reach, double omega,
                                 double time_step = 0);

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
                                           const SideCondition& condition, double omega,
                                           double time_step = 0);

/// The largest of all waves that travel. Where side_reflection() has no finite answer, as at a
/// resonance, it is infinite.
struct LargestAmplification {
    Amplification value;
    std::size_t samples = 0;
    std::size_t examined = 0;  ///< of them, the others being at the edges of bands
};

/// Sought on samples x (samples + 1) wave vectors of both branches, and around the largest ones:
/// what is narrower than they are apart may be missed.
LargestAmplification largest_amplification(const PlaneLattice& lattice,
                                           const SideCondition& condition, std::size_t samples,
                                           double time_step = 0);

/// The part of its energy that comes back, in any polarisation.
double reflected_in_plane(const ArrivingWave& wave, const SideCondition& condition,
                          std::size_t reach);

}  // namespace nmbcgen
