// SPDX-License-Identifier: MIT
#include "generator/stability/least_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "generator/exact/rational.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/support/on_all_cores.hpp"

namespace nmbcgen {
namespace {

using nmbc::Window;

/// The longest chain that grows in such steps [dX/c]; 0: none does. Throws NotCertifiable.
std::size_t longest_growing(const HalfSpace& half_space, double time_step) {
    constexpr std::size_t every_one_to = 24;
    constexpr std::size_t least_step_beyond = 3;  // or a tenth of the length
    constexpr std::size_t at_least_to = 60;
    constexpr std::size_t farthest = 400;  // 39 is the most of the committed tables
    constexpr double roundings = 1e-8;     // of eigenvalues, with double ones near 1
    const LatticeEnd end{LatticeEnd::Kind::matching, half_space};
    const std::size_t first = std::max<std::size_t>(
        1, (half_space.c.size() - 1) * std::size_t(half_space.stride));  // that the end reads
    std::size_t longest = 0;
    for (std::size_t nodes = first; nodes <= std::max(at_least_to, 2 * longest);
         nodes += nodes < every_one_to ? 1 : std::max(least_step_beyond, nodes / 10)) {
        if (spectral_radius(end, nodes, time_step) > 1 + roundings) {
            longest = nodes;
        }
        if (longest > farthest) {
            throw NotCertifiable(
                "no certificate: a chain of " + std::to_string(longest) +
                " nodes is found to grow in steps in which its ends are stable, which roundings "
                "feign where G is large. Take a smaller G, or write the table --uncertified");
        }
    }
    return longest;
}

/// Pieces that follow each other, as one window.
std::vector<Window> rows_of(const std::vector<StableStep>& pieces) {
    std::vector<Window> rows;
    for (const StableStep& piece : pieces) {
        if (!rows.empty() && rows.back().high == piece.window.low) {
            rows.back().high = piece.window.high;
        } else {
            rows.push_back(piece.window);
        }
    }
    return rows;
}

/// In which it is looked at; off the edges, where there may be a pole.
std::vector<double> samples_of(const Window& row) {
    if (row.high == row.low) {
        return {row.low};
    }
    const double length = std::isinf(row.high) ? row.low + 1 : row.high - row.low;
    std::vector<double> samples;
    for (const double part : {1e-6, 1 / 3.0, 2 / 3.0, 1 - 1e-6}) {
        samples.push_back(row.low + part * length);
    }
    return samples;
}

}  // namespace

unsigned least_nodes(const Table& table, const Certificate& certificate) {
    const double own_step = nearest_double(table.specification.time_step);
    struct Stepped {
        HalfSpace half_space;
        double time_step;
    };
    std::vector<Stepped> all;
    for (const Window& row : rows_of(certificate.max_cfl)) {
        for (const double G : samples_of(row)) {
            const HalfSpace half_space = make_half_space(table, Rational(G));
            const double unit = 2 / maximum_frequency(half_space);
            const auto piece = std::ranges::find_if(
                certificate.max_cfl,
                [G](const StableStep& steps) { return steps.window.contains(G); });
            constexpr double short_cfl = 0.05;
            const double shortest = std::max(piece->from, std::min(short_cfl, piece->cfl));
            const std::vector<double> steps = own_step > 0
                                                  ? std::vector{own_step}
                                                  : std::vector{unit * piece->cfl, unit * shortest};
            for (const double time_step : steps) {
                all.push_back({half_space, time_step});
            }
        }
    }
    if (all.empty()) {
        return 0;
    }
    std::vector<std::size_t> longest_of(all.size());
    on_all_cores(all.size(), [&](std::size_t i) {
        longest_of[i] = longest_growing(all[i].half_space, all[i].time_step);
    });
    const std::size_t longest = std::ranges::max(longest_of);
    const auto of_forces = unsigned(table.model.symbol.size() - 1);
    const unsigned of_condition = table.specification.order * table.specification.stride;
    return std::max({of_forces, of_condition, unsigned(longest + 1 + (longest + 3) / 4)});
}

}  // namespace nmbcgen
