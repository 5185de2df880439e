// SPDX-License-Identifier: MIT
/// Waves of a half plane at one frequency and one wave number along its side, in continuous time
/// and without damping: U z^I exp(i omega t), I layers inwards. What grows has exp(s t) in place of
/// exp(i omega t), and damping counts: decaying_plane_modes().
///
/// Those that travel inwards or decay go out from the side; their mirror images (1/z, the normal
/// component reversed) come to it.
#pragma once

#include <complex>
#include <vector>

#include "generator/plane/plane_lattice.hpp"

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

/// Of motions exp(s t), Re s > 0, damped or not: U z^I with |z| < 1, which is half of all modes.
std::vector<PlaneMode> decaying_plane_modes(const LateralChain& chain, std::complex<double> s);

/// How many of the outgoing modes travel: the first ones.
Eigen::Index travelling_count(const std::vector<PlaneMode>& outgoing);

/// Amplitudes between travelling waves, rows outgoing and columns their mirror images, such that
/// |entry|^2 is a fraction of the incident energy flux.
Eigen::MatrixXcd in_flux_metric(Eigen::MatrixXcd amplitudes,
                                const std::vector<PlaneMode>& outgoing);

/// A P or S wave that comes to a side.
struct ArrivingWave {
    double omega = 0;
    double wave_number = 0;           ///< k_t [1/dX]
    std::vector<PlaneMode> outgoing;  ///< at these
    Eigen::Index column = 0;          ///< of the wave in reflection matrices
};

/// At an angle from the normal, 0 <= angle < pi/2, with wave number xi > 0 [1/dX] so small that
/// modes are P and S. Where another wave just begins to travel at this frequency, the angle is 1e-4
/// off; throws std::domain_error where modes cannot be told there, either.
ArrivingWave arriving_wave(const PlaneLattice& lattice, bool is_P, double xi, double angle);

/// omega^2 of a chain of layers with one component, at real wave number.
double omega_squared(const LateralChain& chain, double xi);

/// The wave of a chain of layers with one component, at real wave number xi. Throws
/// std::domain_error where modes cannot be told.
ArrivingWave arriving_wave(const LateralChain& chain, double xi);

}  // namespace nmbcgen
