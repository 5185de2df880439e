// SPDX-License-Identifier: GPL-2.0-or-later
/// The true reflection of a matching boundary on all 2n ghost layers.
///
/// The layers M = 0 .. 2n-1 carry the same (c, b), so the boundary conditions on a sum of outgoing
/// modes form the matrix [Delta(k_m) k_m^-M], a Vandermonde matrix times a diagonal one, and can
/// be solved by Cramer's rule: an incident k_i makes the outgoing k_o with the amplitude
///     A_o = -Delta(k_i)/Delta(k_o) prod_{l != o} (1/k_i - 1/k_l)/(1/k_o - 1/k_l),
/// Delta(k) = i omega C(k) - B(k).
#pragma once

#include <Eigen/Core>

#include "generator/stability/modes.hpp"

namespace nmbcgen {

/// Reflection at one frequency.
struct Reflection {
    std::vector<Mode> outgoing;  ///< all; the first `matrix.rows()` travel
    /// R(omega) between travelling waves: rows outgoing, columns incident, entry
    /// A_o sqrt(|v_o| / |v_i|), so that |entry|^2 is a fraction of the incident energy flux.
    /// Column j is the mirror image, 1/k, of row j.
    Eigen::MatrixXcd matrix;
    /// A_o for all outgoing modes (rows) and the same columns.
    Eigen::MatrixXcd amplitudes;
};

/// The reflection at frequency omega > 0.
Reflection reflection(const HalfSpace& half_space, double omega);

/// The paper's scalar -Delta(xi)/Delta(-xi) at real wave number xi, omega > 0.
std::complex<double> scalar_reflection(const HalfSpace& half_space, double xi);

/// An upper bound of sup over diagonal phase matrices D of rho(R D): the smallest sigma_max of
/// S R S^-1 found over diagonal S > 0. With at most three travelling waves it is the supremum
/// itself (the structured singular value of up to three complex blocks).
double phase_supremum(const Eigen::MatrixXcd& matrix);

}  // namespace nmbcgen
