// SPDX-License-Identifier: MIT
#include "generator/stability/least_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

#include "generator/exact/rational.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/support/on_all_cores.hpp"

namespace nmbcgen {
namespace {

using nmbc::Window;

/// Chains of one lattice between like ends, in such steps [dX/c].
struct Stepped {
    HalfSpace half_space;
    double time_step;

    bool grow(std::size_t nodes) const {
        constexpr double roundings = 1e-8;  // of eigenvalues, with double ones near 1
        return spectral_radius({LatticeEnd::Kind::matching, half_space}, nodes, time_step) >
               1 + roundings;
    }
};

/// Throws NotCertifiable where so long a chain grows.
void require_short(std::size_t growing) {
    constexpr std::size_t farthest = 400;  // 39 is the most of the committed tables
    if (growing > farthest) {
        throw NotCertifiable(
            "no certificate: a chain of " + std::to_string(growing) +
            " nodes is found to grow in steps in which its ends are stable, which roundings "
            "feign where G is large. Take a smaller G, or write the table --uncertified");
    }
}

/// The longest chain that grows; 0: none does. Throws NotCertifiable.
std::size_t longest_growing(const Stepped& chains) {
    constexpr std::size_t every_one_to = 24;
    constexpr std::size_t least_step_beyond = 3;  // or a tenth of the length
    constexpr std::size_t at_least_to = 60;
    const HalfSpace& half_space = chains.half_space;
    const std::size_t first = std::max<std::size_t>(
        1, (half_space.c.size() - 1) * std::size_t(half_space.stride));  // that the end reads
    std::size_t longest = 0;
    for (std::size_t nodes = first; nodes <= std::max(at_least_to, 2 * longest);
         nodes += nodes < every_one_to ? 1 : std::max(least_step_beyond, nodes / 10)) {
        if (chains.grow(nodes)) {
            longest = nodes;
        }
        require_short(longest);
    }
    return longest;
}

/// The most of find() over all of them.
template <class Find>
std::size_t most_over(const std::vector<Stepped>& all, const Find& find) {
    std::vector<std::size_t> found(all.size());
    on_all_cores(all.size(), [&](std::size_t i) { found[i] = find(all[i]); });
    return found.empty() ? 0 : std::ranges::max(found);
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

/// At these parts of a window, of an endless one of its first 1.
std::vector<double> samples_of(const Window& window, std::initializer_list<double> parts) {
    if (window.high == window.low) {
        return {window.low};
    }
    const double length = std::isinf(window.high) ? 1 : window.high - window.low;
    std::vector<double> samples;
    for (const double part : parts) {
        samples.push_back(window.low + part * length);
    }
    return samples;
}

constexpr double beside = 1e-6;  // off the edges, where there may be a pole

/// In the largest steps and in short ones, over rows of pieces.
std::vector<Stepped> over_rows(const Table& table, const std::vector<StableStep>& pieces) {
    const double own_step = nearest_double(table.specification.time_step);
    std::vector<Stepped> all;
    for (const Window& row : rows_of(pieces)) {
        for (const double G : samples_of(row, {beside, 1 / 3.0, 2 / 3.0, 1 - beside})) {
            const HalfSpace half_space = make_half_space(table, Rational(G));
            const double unit = 2 / maximum_frequency(half_space);
            const auto piece = std::ranges::find_if(
                pieces, [G](const StableStep& steps) { return steps.window.contains(G); });
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
    return all;
}

/// In the largest steps at both ends of every piece: there they are nearest to the stable limit.
std::vector<Stepped> at_edges(const Table& table, const std::vector<StableStep>& pieces) {
    const double own_step = nearest_double(table.specification.time_step);
    std::vector<Stepped> all;
    for (const StableStep& piece : pieces) {
        for (const double G : samples_of(piece.window, {beside, 1 - beside})) {
            const HalfSpace half_space = make_half_space(table, Rational(G));
            const double unit = 2 / maximum_frequency(half_space);
            all.push_back({half_space, own_step > 0 ? own_step : unit * piece.cfl});
        }
    }
    return all;
}

}  // namespace

unsigned least_nodes(const Table& table, const Certificate& certificate) {
    if (certificate.max_cfl.empty()) {
        return 0;
    }
    const auto enough = [&](std::size_t growing) {
        const auto of_forces = unsigned(table.model.symbol.size() - 1);
        const unsigned of_condition = table.specification.order * table.specification.stride;
        return std::max({of_forces, of_condition, unsigned(growing + 1 + (growing + 3) / 4)});
    };
    unsigned least = enough(most_over(over_rows(table, certificate.max_cfl), longest_growing));
    const std::vector<Stepped> edges = at_edges(table, certificate.max_cfl);
    for (;;) {
        const std::size_t growing = most_over(edges, [least](const Stepped& chains) {
            constexpr unsigned longer = 3;
            std::size_t longest = 0;
            for (unsigned nodes = least; nodes <= least + longer; ++nodes) {
                longest = chains.grow(nodes) ? nodes : longest;
            }
            return longest;
        });
        if (growing == 0) {
            return least;
        }
        require_short(growing);
        least = enough(growing);
    }
}

}  // namespace nmbcgen
