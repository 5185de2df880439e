// SPDX-License-Identifier: GPL-2.0-or-later
/// The part of proof.hpp that is about matching points.
#pragma once

#include "generator/table/table.hpp"

namespace nmbcgen {

/// Establishes in 120 digits, for each matching point, that
///   - s = +-i omega, or with damping or in time steps the root of its equation (taylor.hpp), with
///     Im s of the sign of the group velocity,
///   - the residual s C(z) - B(z) and its derivatives in i xi below the multiplicity are less than
///     1e-30 of the sum of their terms,
///   - C(z) is not zero there, so that the wave is absorbed.
/// Throws std::logic_error naming what fails.
void prove_points(const Table& table);

}  // namespace nmbcgen
