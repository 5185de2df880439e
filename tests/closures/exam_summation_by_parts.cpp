// SPDX-License-Identifier: GPL-2.0-or-later
/// Summation by parts: exact operators, and that the runtime ends chains with them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nmbc/edge_closure.hpp>
#include <nmbc/lattice.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "generator/closures/summation_by_parts.hpp"
#include "generator/exact/rational.hpp"

using namespace nmbcgen;

namespace {

std::vector<Rational> constant_influence(unsigned n) {
    return std::vector<Rational>(n, Rational(1));
}

std::vector<Rational> inverse(unsigned n) {
    std::vector<Rational> weights;
    for (unsigned k = 1; k <= n; ++k) {
        weights.emplace_back(1, k);
    }
    return weights;
}

std::string text_of(const std::vector<Rational>& numbers) {
    std::string text;
    for (const Rational& number : numbers) {
        text += (text.empty() ? "" : " ") + to_string(number);
    }
    return text;
}

/// Q of a chain of so many nodes between two ends, mirror images of each other.
std::vector<std::vector<Rational>> whole(const SummationByParts& parts, std::size_t nodes) {
    const std::size_t n = parts.inside.size();
    std::vector<std::vector<Rational>> Q(nodes, std::vector<Rational>(nodes));
    for (std::size_t i = 0; i < nodes; ++i) {
        for (std::size_t j = 0; j < 2 * n; ++j) {
            if (i < n) {
                Q[i][j] = parts.rows[i][j];
                Q[nodes - 1 - i][nodes - 1 - j] = -parts.rows[i][j];
            }
        }
        for (std::size_t k = 1; k <= n && i >= n && i + n < nodes; ++k) {
            Q[i][i + k] = parts.inside[k - 1];
            Q[i][i - k] = -parts.inside[k - 1];
        }
    }
    return Q;
}

}  // namespace

TEST_CASE("operators, worked out by hand") {
    const SummationByParts two = summation_by_parts(constant_influence(2));
    CHECK(text_of(two.volumes) == "7/10 4/5");
    CHECK(text_of(two.rows[0]) == "-1/2 3/10 1/5 0");
    CHECK(text_of(two.rows[1]) == "-3/10 0 1/10 1/5");
    CHECK(text_of(summation_by_parts(constant_influence(1)).volumes) == "1/2");
    CHECK(text_of(summation_by_parts(inverse(2)).volumes) == "2/3 5/6");
    CHECK(text_of(summation_by_parts(constant_influence(3)).volumes) == "11/12 2/3 11/12");
}

TEST_CASE("sums by parts, exactly, and takes shifts to 0 and x to 1") {
    for (unsigned n = 1; n <= 8; ++n) {
        for (const auto& weights : {constant_influence(n), inverse(n)}) {
            const SummationByParts parts = summation_by_parts(weights);
            const std::size_t nodes = std::size_t{4} * n;
            const auto Q = whole(parts, nodes);
            for (std::size_t i = 0; i < nodes; ++i) {
                Rational sum = 0;
                Rational slope = 0;
                for (std::size_t j = 0; j < nodes; ++j) {
                    sum += Q[i][j];
                    slope += Q[i][j] * int(j);
                    Rational end = 0;
                    if (i == j && (i == 0 || i + 1 == nodes)) {
                        end = i == 0 ? -1 : 1;
                    }
                    CHECK(Q[i][j] + Q[j][i] == end);
                }
                const std::size_t depth = std::min(i, nodes - 1 - i);
                CHECK(sum == 0);
                CHECK(slope == (depth < n ? parts.volumes[depth] : Rational(1)));
                CHECK(slope > 0);
            }
        }
    }
}

TEST_CASE("of all such operators it is the nearest to the lattice's own") {
    // Whatever can be added to the free entries, antisymmetric and with rows that add up to 0, is
    // at right angles to the differences. At n = 4 it is spanned by triangles of nodes.
    for (const unsigned n : {3U, 4U, 7U}) {
        const SummationByParts parts = summation_by_parts(inverse(n));
        const auto difference = [&](std::size_t i, std::size_t j) {
            return parts.rows[i][j] - parts.inside[j - i - 1];
        };
        for (std::size_t a = 0; a < n; ++a) {
            for (std::size_t b = a + 1; b < n; ++b) {
                for (std::size_t c = b + 1; c < n; ++c) {
                    CHECK(difference(a, b) + difference(b, c) - difference(a, c) == 0);
                }
            }
        }
    }
}

TEST_CASE("a node is left no volume by weights that dance") {
    CHECK_THROWS_AS(summation_by_parts(std::vector<Rational>{2, 172562, 2, 97, 8, 2, 13, 2, 34}),
                    std::domain_error);
}

TEST_CASE("the runtime finds the operators that are derived here") {
    for (unsigned n = 1; n <= 6; ++n) {
        for (const auto& weights : {constant_influence(n), inverse(n)}) {
            const SummationByParts parts = summation_by_parts(weights);
            nmbc::Lattice lattice;  // by its strain alone
            lattice.symbol.resize(2 * n + 1);
            std::vector<double> strain(2 * n + 1);
            for (unsigned k = 1; k <= n; ++k) {
                strain[n + k] = nearest_double(parts.inside[k - 1]);
                strain[n - k] = -strain[n + k];
            }
            lattice.energy.push_back({nmbc::EnergyPart::strain, 1, strain});
            const nmbc::EdgeEnergy edge = nmbc::sbp_edge(lattice);
            REQUIRE(edge.mass.size() == n);
            REQUIRE(edge.squares.size() == n);
            for (std::size_t i = 0; i < n; ++i) {
                const double volume = nearest_double(parts.volumes[i]);
                constexpr double roundings = 1e-13;
                CHECK(edge.mass[i] == doctest::Approx(volume).epsilon(roundings));
                CHECK(edge.squares[i].weight == doctest::Approx(volume).epsilon(roundings));
                for (std::size_t j = 0; j < edge.squares[i].stencil.size(); ++j) {
                    CHECK(std::abs(edge.squares[i].stencil[j] * volume -
                                   nearest_double(parts.rows[i][j])) < roundings);
                }
            }
        }
    }
}
