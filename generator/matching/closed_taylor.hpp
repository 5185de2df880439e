// SPDX-License-Identifier: GPL-2.0-or-later
/// Taylor coefficients of the dispersion relation for all horizons at once.
#pragma once

#include "generator/table/closed_forms.hpp"

namespace nmbcgen {

/// a_1, a_3, .. a_{2N+1} of (47) from the coefficients of x^2, x^4, .. x^(2N+2), x = i xi, in
/// -omega^2. Throws std::invalid_argument where the first of those is not 1.
ClosedForms closed_taylor(const ClosedForms& moments);

}  // namespace nmbcgen
