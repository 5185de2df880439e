// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/matching/solve.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "generator/matching/real.hpp"

namespace nmbcgen {
namespace {

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

const auto nonzero = [](const Rational& candidate, const Rational& best) {
    return best == 0 && candidate != 0;
};
const auto larger = [](const Real& candidate, const Real& best) {
    return abs(candidate) > abs(best) && abs(candidate) > negligible;
};

Rational rounded(const Real& value, unsigned digits) {
    const Integer scale = pow(Integer(10), digits);
    return {Integer(round(value * Real(scale))), scale};
}

/// The row in the free unknowns alone: the others, bound by the rows of an echelon form, put in.
std::vector<Real> in_free(std::vector<Real> row, const Rows<Rational>& echelon,
                          const std::vector<std::size_t>& bound,
                          const std::vector<std::size_t>& free) {
    for (std::size_t i = 0; i < bound.size(); ++i) {
        const Real factor = row[bound[i]];
        for (std::size_t k = 0; k < row.size(); ++k) {
            row[k] -= factor * Real(echelon[i][k]);
        }
    }
    std::vector<Real> result;
    result.reserve(free.size() + 1);
    for (const std::size_t k : free) {
        result.push_back(row[k]);
    }
    result.push_back(row.back());
    return result;
}

}  // namespace

Solution solve(Rows<Rational> exact, const Rows<Real>& others, unsigned digits) {
    const std::size_t count = others.front().size() - 1;
    const std::vector<std::size_t> bound = reduce(exact, nonzero);
    std::vector<std::size_t> free;
    for (std::size_t k = 0; k < count; ++k) {
        if (std::ranges::find(bound, k) == bound.end()) {
            free.push_back(k);
        }
    }
    Rows<Real> rows;
    rows.reserve(others.size());
    for (const std::vector<Real>& row : others) {
        rows.push_back(in_free(row, exact, bound, free));
    }
    if (bound.size() < exact.size() || reduce(rows, larger).size() < free.size()) {
        return {};
    }
    Solution solution{std::vector<Real>(count), std::vector<Rational>(count)};
    for (std::size_t i = 0; i < free.size(); ++i) {
        solution.full[free[i]] = rows[i].back();
        solution.rounded[free[i]] = rounded(rows[i].back(), digits);
    }
    for (std::size_t i = 0; i < bound.size(); ++i) {
        Rational value = exact[i].back();
        Real full = Real(value);
        for (const std::size_t k : free) {
            value -= exact[i][k] * solution.rounded[k];
            full -= Real(exact[i][k]) * solution.full[k];
        }
        solution.rounded[bound[i]] = value;
        solution.full[bound[i]] = full;
    }
    return solution;
}

}  // namespace nmbcgen
