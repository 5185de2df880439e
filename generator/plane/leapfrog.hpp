// SPDX-License-Identifier: MIT
/// Motions exp(s t) of a lattice in leapfrog steps whose ghost layers move by the midpoint rule. A
/// time step of 0 is continuous time.
///
/// In continuous time the lattice says s^2 U = -K(z) U, and a side has D = s in its residual. In
/// steps, lambda = exp(s dt), the lattice says the same of S = (2/dt) sinh(s dt/2), and the means
/// and differences of the midpoint rule make of D
///     (2/dt) (lambda - 1)/(lambda + 1) = (2/dt) tanh(s dt/2) = S/sqrt(1 + (S dt/2)^2),
/// so that Re D > 0 where the motion grows.
#pragma once

#include <Eigen/Core>
#include <complex>

#include "generator/plane/side_condition.hpp"

namespace nmbcgen {

/// D of a wave whose frequency in continuous time is omega < 2/dt: S = i omega.
std::complex<double> rate_at_side(double omega, double time_step);

/// The residual as what is known before a step sees it: displacements u, velocities v half a step
/// before, and as its highest derivative the change that the step makes: with D^1 the highest, the
/// new v; with D^2, (new v - v)/dt.
ShiftPolynomial at_midpoints(ShiftPolynomial residual, double time_step);

/// The largest Re s of motions whose state has these eigenvalues: of d/dt, or of a step.
double largest_growth(const Eigen::VectorXcd& eigenvalues, double time_step);

}  // namespace nmbcgen
