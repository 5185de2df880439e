// SPDX-License-Identifier: MIT
/// A compiled table as the generator's exact data, for its stability analysis.
#pragma once

#include <nmbc/table.hpp>

#include "generator/table/table.hpp"

namespace nmbcrun {

/// Family, horizon, order, stride, tau, time step, symbol, damping, c and b of the table; the rest
/// stays empty.
nmbcgen::Table exact_table(const nmbc::MatchingTable& table);

}  // namespace nmbcrun
