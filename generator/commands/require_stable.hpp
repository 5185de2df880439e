// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen --require-stable.
#pragma once

#include <optional>
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

/// What it finds of a wave of a plane: the grade of the condition as a side of the plane, with its
/// like for the other polarisation. Throws NotStable where the modal certificate of a table at a
/// fixed G does not cover that G, and where such a side grows or amplifies on the samples of
/// ghost_side.hpp.
std::optional<PlaneGrade> require_stable(const Table& table);

}  // namespace nmbcgen
