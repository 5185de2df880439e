// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/matching/points_equations.hpp"

#include <algorithm>
#include <cstddef>

#include "generator/matching/real.hpp"

namespace nmbcgen {
namespace {

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
    const std::vector<std::size_t> bound = reduce(exact, count, nonzero);
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
    if (bound.size() < exact.size() || reduce(rows, free.size(), larger).size() < free.size()) {
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
