// SPDX-License-Identifier: MIT
#include "generator/passive/plane_side.hpp"

#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "generator/exact/rational.hpp"
#include "generator/families/projected.hpp"
#include "generator/families/vector_family.hpp"

namespace nmbcgen {
namespace {

/// Long waves count more, and so do steep ones: more of their energy meets a side, and sooner.
std::vector<WeightedWave> designed_waves(const PlaneLattice& lattice) {
    std::vector<WeightedWave> waves;
    for (const double angle : {0.0, 15.0, 30.0, 45.0, widest_designed_angle}) {
        for (const double xi :
             {0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0}) {
            for (const bool is_P : {true, false}) {
                const ArrivingWave wave = wave_at(lattice, is_P, xi, angle);
                const PlaneMode& mode = wave.outgoing[std::size_t(wave.column)];
                // Where waves stand, or go backwards, their angle is not that of their energy.
                const double slow = 0.2 * (is_P ? lattice.speed_P : lattice.speed_S);
                if (mode.group_velocity > slow) {
                    const double cosine = std::cos(angle * std::numbers::pi / 180);
                    waves.push_back({wave, cosine * std::sqrt(cosine) / xi});
                }
            }
        }
    }
    return waves;
}

}  // namespace

ArrivingWave wave_at(const PlaneLattice& lattice, bool is_P, double xi, double degrees) {
    try {
        return arriving_wave(lattice, is_P, xi, degrees * std::numbers::pi / 180);
    } catch (const std::domain_error& error) {
        std::ostringstream text;
        text << (is_P ? 'P' : 'S') << " waves of xi = " << xi << "/dX at " << degrees
             << " degrees: " << error.what();
        throw std::domain_error(text.str());
    }
}

DesignedSide passive_side(const SideTask& model) {
    const VectorFamily& family = find_vector_family(model.family);
    const PlaneLattice lattice = plane_lattice(family.describe(model.choice), model.g, 0);
    constexpr std::size_t wave_numbers = 32;
    const auto node = Eigen::Index(horizon_of(model.choice));
    const auto forces = Eigen::Index(lateral_chain(lattice, 0).reach());
    const Rational largest_beta =
        model.has_null_lagrangian ? family.largest_beta(model.choice) : Rational(0);
    EdgeTask task{.squares = EdgeSquares(
                      [&](unsigned layer, const Rational& beta) {
                          return family.at_edge(model.choice, layer, beta);
                      },
                      node, model.g, largest_beta),
                  .dimensions = 2,
                  .reach = {.node = node, .forces = forces, .layers = 2 * node},
                  .has_stabilisation = model.g != 0,
                  .largest_beta = largest_beta,
                  .long_steps = 10,
                  .highest_eigenvalue = highest_eigenvalue(lattice, wave_numbers),
                  .time_step = nearest_double(model.time_step)};
    return designed_side(std::move(task), designed_waves(lattice),
                         {lattice.speed_P, lattice.speed_S}, wave_numbers);
}

nmbc::PassiveSide for_runtime(const DesignedSide& side) {
    const PassiveEdge& edge = side.edge;
    return {.strain = entries_of(edge.strain),
            .stabilisation = entries_of(edge.stabilisation),
            .mass = {entries_of(edge.mass.col(0)), entries_of(edge.mass.col(1))},
            .dashpots = {entries_of(edge.dashpots[0]), entries_of(edge.dashpots[1])},
            .null_lagrangian = edge.null_lagrangian};
}

}  // namespace nmbcgen
