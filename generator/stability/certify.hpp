// SPDX-License-Identifier: MIT
/// The stability of a table at three levels: the paper's scalar reflection, the half space, and
/// steps in time.
#pragma once

#include "generator/table/certificate.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// Where the table is stable. Of a table at a fixed G the windows are that G or empty.
Certificate certify(const Table& table);

}  // namespace nmbcgen
