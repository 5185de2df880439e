// SPDX-License-Identifier: GPL-2.0-or-later
/// Sets of G as unions of intervals.
#pragma once

#include <optional>

#include "generator/table/algebraic.hpp"

namespace nmbcgen {

/// The values from low to high; none: infinity, or the top of what was searched.
struct Window {
    AlgebraicNumber low;
    std::optional<AlgebraicNumber> high;
};

}  // namespace nmbcgen
