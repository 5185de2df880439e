// SPDX-License-Identifier: GPL-2.0-or-later
/// Symbol and damping -> Taylor coefficients of the dispersion relation.
#pragma once

#include <ginac/ginac.h>

#include <vector>

namespace nmbcgen {

/// Waves exp(s t + i xi I) of a lattice obey  s^2 + tau sigma s + omega^2 = 0,  dX = 1, with
///     omega^2 = symbol[0] + sum_{m >= 1} symbol[m] (z^m + z^-m),   z = exp(i xi),
/// and tau sigma likewise of damping, which is empty where nothing is damped.
///
/// In leapfrog steps of dt, the factor of each being zeta, a boundary with midpoint ghosts sees
/// s = (2/dt) (zeta - 1)/(zeta + 1) in the place of d/dt. The damping force takes the old velocity,
///     (zeta - 2 + 1/zeta)/dt^2 = -omega^2 - tau sigma (1 - 1/zeta)/dt,
/// so that  s^2 + tau sigma s (1 - s dt/2) + omega^2 (1 - s^2 dt^2/4) = 0.
struct Dispersion {
    std::vector<GiNaC::ex> symbol;
    std::vector<GiNaC::ex> damping;
    GiNaC::ex time_step = 0;  ///< dt [dX/c]; 0: continuous time
};

/// a_0 .. a_highest of  s(xi) = sum_k a_k (i xi)^k, a_1 = 1; without damping the even ones are
/// zero, and s = i omega (47) in continuous time. Throws std::invalid_argument where omega^2 does
/// not start as xi^2, that is, where the model does not carry long waves at c = 1, and where a
/// rigid motion is damped.
std::vector<GiNaC::ex> taylor_coefficients(const Dispersion& dispersion, unsigned highest);

/// All that the coefficients depend on.
struct Moments {
    std::vector<GiNaC::ex> symbol;   ///< coefficients of x^0 .. x^highest, x = i xi, in -omega^2
    std::vector<GiNaC::ex> damping;  ///< likewise in -tau sigma
    GiNaC::ex time_step = 0;         ///< as of Dispersion
};

/// The same from the moments through x^(highest + 1), highest >= 1.
std::vector<GiNaC::ex> taylor_coefficients(const Moments& moments);

}  // namespace nmbcgen
