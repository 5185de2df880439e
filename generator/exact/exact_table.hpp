// SPDX-License-Identifier: MIT
/// From the runtime's tables back to exact data.
#pragma once

#include <nmbc/table.hpp>

#include "generator/table/table.hpp"

namespace nmbcgen {

/// All of the table but its certificate, of which the runtime has doubles alone, and its matching
/// points, which it does not have. Its texts are those that the generator writes.
Table exact_table(const nmbc::MatchingTable& table);

}  // namespace nmbcgen
