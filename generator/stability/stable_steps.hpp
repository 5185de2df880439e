// SPDX-License-Identifier: MIT
/// The largest time step over whole windows of G.
#pragma once

#include <vector>

#include "generator/stability/half_space.hpp"
#include "generator/stability/modal.hpp"
#include "generator/table/certificate.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// Pieces of G within the windows, ascending, each with a cfl that has this grade in all of it; a
/// piece without one is left out. The cfl is that of largest_cfl() at both ends and in the middle,
/// where they differ by more than 0.06 for smaller pieces, and 0.01 less than the least of them for
/// what may lie between. A window without an end is sampled to 1000 times where it begins.
std::vector<StableStep> stable_steps(const Table& table,
                                     const std::vector<StabilityWindow>& windows, GhostRule ghosts,
                                     Grade least);

}  // namespace nmbcgen
