// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen --require-stable.
#pragma once

#include <stdexcept>
#include <string>

#include "generator/table/table.hpp"

namespace nmbcgen {

/// The table is not stable at its G; what() says how it fails and what would be stable.
struct NotStable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// How a table at a fixed G, whose certificate is empty, is not stable there.
std::string why_uncertified(const Table& table);

/// Throws NotStable where the modal certificate of a table at a fixed G does not cover that G, and,
/// of a wave of a plane, where the condition grows or amplifies as a side of the plane, with its
/// like for the other polarisation, on the samples of ghost_side.hpp.
void require_stable(const Table& table);

}  // namespace nmbcgen
