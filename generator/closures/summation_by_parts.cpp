// SPDX-License-Identifier: MIT
#include "generator/closures/summation_by_parts.hpp"

#include <stdexcept>

namespace nmbcgen {
namespace {

/// Of Q. missing: what the sums of the n first rows of the lattice's own Q fall short of 0.
std::vector<Rational> row_of(const std::vector<Rational>& inside,
                             const std::vector<Rational>& missing, std::size_t node) {
    const std::size_t n = inside.size();
    std::vector<Rational> row(2 * n);
    row[node] = node == 0 ? Rational(-1, 2) : Rational(0);
    for (std::size_t other = 0; other <= node + n && other < 2 * n; ++other) {
        if (other > node) {
            row[other] = inside[other - node - 1];
        } else if (other < node) {
            row[other] = -inside[node - other - 1];
        }
        if (other < n && other != node) {
            row[other] += (missing[node] - missing[other]) / n;
        }
    }
    return row;
}

}  // namespace

SummationByParts summation_by_parts(std::span<const Rational> weights) {
    const std::size_t n = weights.size();
    SummationByParts parts;
    Rational shape = 0;  // of (16), both sides
    for (std::size_t k = 1; k <= n; ++k) {
        shape += 2 * k * k * weights[k - 1];
    }
    for (std::size_t k = 1; k <= n; ++k) {
        parts.inside.emplace_back(k * weights[k - 1] / shape);
    }
    std::vector<Rational> missing(n);
    missing[0] = Rational(1, 2);
    for (std::size_t node = 0; node < n; ++node) {
        for (std::size_t k = node + 1; k <= n; ++k) {
            missing[node] -= parts.inside[k - 1];
        }
    }
    for (std::size_t node = 0; node < n; ++node) {
        parts.rows.push_back(row_of(parts.inside, missing, node));
        Rational volume = 0;  // Q x, x counted from this node
        for (std::size_t other = 0; other < 2 * n; ++other) {
            volume += parts.rows.back()[other] * (Integer(other) - Integer(node));
        }
        if (volume <= 0) {
            throw std::domain_error("a node near the end would have no volume");
        }
        parts.volumes.push_back(std::move(volume));
    }
    return parts;
}

}  // namespace nmbcgen
