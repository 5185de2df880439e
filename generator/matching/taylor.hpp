// SPDX-License-Identifier: GPL-2.0-or-later
/// Symbol -> Taylor coefficients of the dispersion relation.
#pragma once

#include <ginac/ginac.h>

#include <vector>

namespace nmbcgen {

/// a_0 .. a_highest of  i omega(xi) = sum_k a_k (i xi)^k  (47), for the symbol
/// omega^2 = symbol[0] + sum_{m >= 1} symbol[m] (z^m + z^-m), dX = 1.
/// Throws std::invalid_argument where omega^2 does not start as xi^2, that is, where the model
/// does not carry long waves at c = 1.
std::vector<GiNaC::ex> taylor_coefficients(const std::vector<GiNaC::ex>& symbol, unsigned highest);

}  // namespace nmbcgen
