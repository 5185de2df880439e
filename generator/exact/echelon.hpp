// SPDX-License-Identifier: MIT
/// Elimination of linear equations over any field.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace nmbcgen {

/// Each row: the coefficients of the unknowns, then the right-hand sides.
template <class T>
using Rows = std::vector<std::vector<T>>;

/// Brings the rows into reduced echelon form, rows without a pivot last. Returns the columns of the
/// pivots. better(a, b): a is the better pivot; a pivot is one that is better than T(0).
template <class T, class Better>
std::vector<std::size_t> reduce(Rows<T>& rows, std::size_t unknowns, Better better) {
    std::vector<std::size_t> pivots;
    for (std::size_t column = 0; column < unknowns && pivots.size() < rows.size(); ++column) {
        const std::size_t top = pivots.size();
        std::size_t best = top;
        for (std::size_t row = top + 1; row < rows.size(); ++row) {
            if (better(rows[row][column], rows[best][column])) {
                best = row;
            }
        }
        if (!better(rows[best][column], T(0))) {
            continue;
        }
        std::swap(rows[top], rows[best]);
        const T pivot = rows[top][column];
        for (T& entry : rows[top]) {
            entry /= pivot;
        }
        for (std::size_t row = 0; row < rows.size(); ++row) {
            if (row == top) {
                continue;
            }
            const T factor = rows[row][column];
            for (std::size_t k = column; k < rows[row].size(); ++k) {
                rows[row][k] -= factor * rows[top][k];
            }
        }
        pivots.push_back(column);
    }
    return pivots;
}

/// Exact fields: the first entry that is not 0.
inline constexpr auto nonzero = [](const auto& candidate, const auto& best) {
    return best == 0 && candidate != 0;
};

}  // namespace nmbcgen
