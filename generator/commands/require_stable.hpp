// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen --require-stable.
#pragma once

#include <stdexcept>

#include "generator/table/table.hpp"

namespace nmbcgen {

/// The table is not stable at its G; what() says how it fails and what would be stable.
struct NotStable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Throws NotStable where the modal certificate of a table at a fixed G does not cover that G.
void require_stable(const Table& table);

}  // namespace nmbcgen
