// SPDX-License-Identifier: MIT
#include "generator/passive/chain_end.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace nmbcgen {
namespace {

double highest_eigenvalue(const LateralChain& chain, std::size_t steps) {
    double highest = 0;
    for (std::size_t i = 1; i < steps; ++i) {
        const double xi = std::numbers::pi * double(i) / double(steps);
        highest = std::max(highest, omega_squared(chain, xi));
    }
    return highest;
}

std::vector<VectorSquare> as_vectors(const std::vector<ExactSquare>& squares, int horizon) {
    std::vector<VectorSquare> vectors;
    for (const ExactSquare& square : squares) {
        std::vector<VectorTerm> terms;
        for (int j = -horizon; j <= horizon; ++j) {
            const Rational& factor = square.stencil[std::size_t(j + horizon)];
            if (factor != 0) {
                terms.push_back({{j, 0, 0}, {factor, 0, 0}});
            }
        }
        vectors.push_back({square.part, square.weight, std::move(terms)});
    }
    return vectors;
}

/// Some searches end in a minimum far from the lattice, and others do not, which count stiffness
/// more: the best of those that end at all.
DesignedSide best_of_searches(EdgeTask task, const std::vector<WeightedWave>& waves) {
    constexpr double good = 1e-3;  // of the energy: better ones are not looked for
    std::optional<DesignedSide> best;
    double least = HUGE_VAL;
    std::string why_none = "the search found nothing that reflects a part of the waves only";
    for (const double weight : {0.3, 1.0, 3.0}) {
        task.long_steps = weight;
        try {
            DesignedSide side = designed_side(task, waves, {1}, 1);
            double reflected = 0;
            for (const WeightedWave& one : waves) {
                reflected += reflected_by_edge(side.task, side.edge, one.wave);
            }
            reflected /= double(waves.size());
            if (reflected < least) {
                least = reflected;
                best = std::move(side);
            }
        } catch (const std::domain_error& error) {
            why_none = error.what();
        }
        if (least < good) {
            break;
        }
    }
    if (!best) {
        throw std::domain_error(why_none);
    }
    return *best;
}

}  // namespace

nmbc::PassiveEnd for_runtime(const DesignedSide& side, const EdgeEnergies& energies) {
    const auto rows = side.task.reach.interior();
    // What decays does so by a half or more from node to node at the values of G that suit waves.
    return {.rows = std::size_t(rows),
            .stiffness = entries_of(energies.stiffness(side.edge).topRows(rows)),
            .mass = entries_of(side.edge.mass),
            .dashpots = entries_of(side.edge.dashpots.front()),
            .highest_eigenvalue = side.eigenvalue_bound(),
            .further = std::size_t(4 * side.task.reach.node)};
}

LateralChain chain_of(const std::vector<double>& symbol) {
    LateralChain chain;
    const auto add = [&](double entry) {
        chain.stiffness.emplace_back(Eigen::MatrixXd::Constant(1, 1, entry));
    };
    std::for_each(symbol.rbegin(), symbol.rend() - 1, add);
    std::ranges::for_each(symbol, add);
    return chain;
}

DesignedSide passive_end(const std::vector<double>& symbol, unsigned horizon, const Rational& G,
                         const ChainEdge& at_edge, double time_step) {
    const auto n = Eigen::Index(horizon);
    const LateralChain chain = chain_of(symbol);
    constexpr std::size_t steps = 400;
    EdgeTask task{.squares = EdgeSquares(
                      [&](unsigned layer, const Rational&) {
                          return as_vectors(at_edge(layer), int(horizon));
                      },
                      n, G, 0),
                  .dimensions = 1,
                  .reach = {.node = n, .forces = 2 * n, .layers = 2 * n},
                  .has_stabilisation = G != 0,
                  .largest_beta = 0,
                  .is_exact_head_on = true,
                  .near_the_lattice = 1e-3,
                  .denominator = 1000000,
                  .highest_eigenvalue = highest_eigenvalue(chain, steps),
                  .time_step = time_step};
    std::vector<WeightedWave> waves;
    for (const double xi : {0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0}) {
        const ArrivingWave wave = arriving_wave(chain, xi);
        constexpr double slow = 0.2;
        if (wave.outgoing[std::size_t(wave.column)].group_velocity > slow) {
            waves.push_back({wave, 1 / xi});
        }
    }
    return best_of_searches(std::move(task), waves);
}

DesignedSide atom_chain_end() {
    const double root = std::sqrt(5.0);
    const double x = (3 - root) / 2;
    const double bond = std::sqrt(8 * (root - 2));
    PassiveEdge edge{.strain = Eigen::Vector2d(bond, 1),
                     .stabilisation = Eigen::Vector2d::Ones(),
                     .mass = Eigen::Vector2d(x / bond, 0.5 + (1 - x) / bond),
                     .dashpots = {Eigen::Matrix2d::Zero()},
                     .null_lagrangian = 0};
    edge.dashpots[0](0, 0) = 1;
    // A bond belongs to the one of its nodes that is nearer to the end.
    const NodeEnergy bonds = [](unsigned, const Rational&) {
        return std::vector<VectorSquare>{
            {EnergyPart::strain,
             Polynomial(std::vector<Rational>{1}),
             {{Offset{0, 0, 0}, {-1, 0, 0}}, {Offset{1, 0, 0}, {1, 0, 0}}}}};
    };
    constexpr double highest = 4;  // 4 sin^2(xi/2)
    DesignedSide side{.task = {.squares = EdgeSquares(bonds, 1, 0, 0),
                               .dimensions = 1,
                               .reach = {.node = 1, .forces = 1, .layers = 2},
                               .has_stabilisation = false,
                               .largest_beta = 0,
                               .highest_eigenvalue = highest},
                      .design = {},
                      .edge = std::move(edge),
                      .highest_eigenvalue = highest};
    side.highest_eigenvalue =
        std::max(highest, highest_eigenvalue_of_edge(side.task, side.edge, 1));
    return side;
}

}  // namespace nmbcgen
