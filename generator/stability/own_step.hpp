// SPDX-License-Identifier: MIT
/// Conditions that are matched in time steps take one step only: where is that one certified?
#pragma once

#include "generator/table/certificate.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// Cuts the windows and steps of a table that is matched in time steps, found as for any other, to
/// the G at which its own step is one of the certified ones. It is examined itself at both ends of
/// every piece and in the middle.
void cut_to_own_step(const Table& table, Certificate& certificate);

}  // namespace nmbcgen
