// SPDX-License-Identifier: MIT
/// Exact integrals over pairs of elements.
#pragma once

#include <tuple>
#include <vector>

#include "generator/coupling/log_number.hpp"

namespace nmbcgen {

/// What becomes of the pairs (x, x').
enum class CouplingForm {
    /// a(u, v) = (1/2) int int (v' - v) c(x', x) (u' - u) dx' dx: symmetric, an energy. Both points
    /// of a pair get the same force, of opposite sign, of either one's horizon.
    pairs,
    /// int v(x) int c(x', x) (u - u') dx' dx: every point has the force of its own horizon. A
    /// uniform strain makes none, whatever the horizons are; it is not symmetric.
    rows,
};

/// x in the element [0, length], x' in [gap, gap + other_length] and closer to x than the horizon.
struct ElementPair {
    Rational length;
    Rational gap;
    Rational other_length;
    Rational horizon;

    friend bool operator<(const ElementPair& left, const ElementPair& right) {
        return std::tie(left.length, left.gap, left.other_length, left.horizon) <
               std::tie(right.length, right.gap, right.other_length, right.horizon);
    }
};

/// The matrix of the form at k = 1, row by row, of the ends of the first element and then, unless
/// it is the same one, gap = 0, of the second. Elements do not overlap otherwise.
std::vector<LogNumber> pair_matrix(const ElementPair& pair, CouplingForm form);

}  // namespace nmbcgen
