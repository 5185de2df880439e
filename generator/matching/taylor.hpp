// SPDX-License-Identifier: GPL-2.0-or-later
/// Symbol and damping -> Taylor coefficients of the dispersion relation.
#pragma once

#include <ginac/ginac.h>

#include <vector>

namespace nmbcgen {

/// Waves exp(s t + i xi I) of a lattice obey  s^2 + tau sigma s + omega^2 = 0,  dX = 1, with
///     omega^2 = symbol[0] + sum_{m >= 1} symbol[m] (z^m + z^-m),   z = exp(i xi),
/// and tau sigma likewise of damping, which is empty where nothing is damped.
struct Dispersion {
    std::vector<GiNaC::ex> symbol;
    std::vector<GiNaC::ex> damping;
};

/// a_0 .. a_highest of  s(xi) = sum_k a_k (i xi)^k, a_1 = 1; without damping s = i omega (47), and
/// the even ones are zero.
/// Throws std::invalid_argument where omega^2 does not start as xi^2, that is, where the model
/// does not carry long waves at c = 1, and where a rigid motion is damped.
std::vector<GiNaC::ex> taylor_coefficients(const Dispersion& dispersion, unsigned highest);

}  // namespace nmbcgen
