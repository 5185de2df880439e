// SPDX-License-Identifier: MIT
/// A compiled table's end, as the generator's stability analysis takes it.
#pragma once

#include <nmbc/table.hpp>

#include "generator/stability/half_space.hpp"

namespace nmbcrun {

/// A table's end at G, in continuous time. Throws std::domain_error at a pole of the coefficients.
nmbcgen::HalfSpace half_space_of(const nmbc::MatchingTable& table, double G);

/// Whether a coefficient of the table has a pole at an exact G that this double is the nearest to.
bool has_pole_next_to(const nmbc::MatchingTable& table, double G);

}  // namespace nmbcrun
