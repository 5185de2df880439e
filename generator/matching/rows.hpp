// SPDX-License-Identifier: GPL-2.0-or-later
/// Linear equations over any field.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace nmbcgen {

/// Each row: the coefficients of the unknowns, then the right-hand side.
template <class T>
using Rows = std::vector<std::vector<T>>;

/// Brings the rows into reduced echelon form, rows without a pivot last. Returns the columns of the
/// pivots. better(a, b): a is the better pivot; a pivot is one that is better than T(0).
template <class T, class Better>
std::vector<std::size_t> reduce(Rows<T>& rows, Better better) {
    std::vector<std::size_t> pivots;
    const std::size_t unknowns = rows.empty() ? 0 : rows.front().size() - 1;
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
            for (std::size_t k = column; k <= unknowns; ++k) {
                rows[row][k] -= factor * rows[top][k];
            }
        }
        pivots.push_back(column);
    }
    return pivots;
}

}  // namespace nmbcgen
