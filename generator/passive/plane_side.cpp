// SPDX-License-Identifier: MIT
#include "generator/passive/plane_side.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "generator/dense/portable_math.hpp"
#include "generator/exact/rational.hpp"
#include "generator/families/projected.hpp"
#include "generator/families/vector_family.hpp"

namespace nmbcgen {
namespace {

struct DesignedWaves {
    std::vector<double> angles;
    std::vector<double> xi;
    double longest = 0;   ///< those with a lower xi count no more than this one
    int steepness = 0;    ///< energies are weighted by cos(angle) to this power
    double S_energy = 1;  ///< weight of the energies of S waves
};

/// Long waves count more, and so do steep ones: more of their energy meets a side, and sooner.
std::vector<WeightedWave> weighted(const DesignedWaves& which, const PlaneLattice& lattice) {
    std::vector<WeightedWave> waves;
    for (const double angle : which.angles) {
        for (const double xi : which.xi) {
            for (const bool is_P : {true, false}) {
                const ArrivingWave wave = wave_at(lattice, is_P, xi, angle);
                const PlaneMode& mode = wave.outgoing[std::size_t(wave.column)];
                // Where waves stand, or go backwards, their angle is not that of their energy.
                const double slow = 0.2 * (is_P ? lattice.speed_P : lattice.speed_S);
                if (mode.group_velocity > slow) {
                    const double cosine = portable::cos(angle * std::numbers::pi / 180);
                    double weight = is_P ? 1 : which.S_energy;
                    for (int i = 0; i < which.steepness; ++i) {
                        weight *= cosine;
                    }
                    waves.push_back({wave, std::sqrt(weight) / std::max(xi, which.longest)});
                }
            }
        }
    }
    return waves;
}

/// The energy of S waves counts twice: they are the slower ones, and the last to leave. With this
/// and the power 5 the least is left of the pulse of Nicely 2018, Table 4, in large families.
const DesignedWaves all_waves{
    .angles = {0, 15, 30, 45, 60},
    .xi = {0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0},
    .steepness = 5,
    .S_energy = 2};

/// More layers can do something about wider angles and about S waves beside the critical one.
/// Heavy layers have low frequencies of their own: lower wave numbers, too. Fewer of these make up
/// for the time.
const DesignedWaves wide_waves{.angles = {0, 15, 30, 35, 45, 60, 75},
                               .xi = {0.02, 0.05, 0.1, 0.2, 0.35, 0.6, 1.0},
                               .longest = 0.1,
                               .steepness = 3};

bool has_more_layers(const EdgeReach& reach) {
    return reach.layers > 2 * reach.node;
}

const DesignedWaves& waves_for(const EdgeReach& reach) {
    return has_more_layers(reach) ? wide_waves : all_waves;
}

/// Sides of bonds, which have no nu, send little back of steep waves anyhow: wide ones count more.
DesignedWaves waves_for(const VectorFamily& family, const EdgeReach& reach) {
    DesignedWaves waves = waves_for(reach);
    if (!family.has_poisson) {
        waves.steepness = wide_waves.steepness;
    }
    return waves;
}

}  // namespace

std::string words_of(const SideTask& side) {
    std::string words = side.family + " radius2 " + std::to_string(side.choice.radius_squared) +
                        (side.choice.poisson ? " nu " + to_string(*side.choice.poisson) : "") +
                        (side.choice.plane_strain ? " strain" : " stress");
    for (const Rational& weight : side.choice.weights) {
        words += " " + to_string(weight);
    }
    return words + " g " + to_string(side.g) + " dt " + to_string(side.time_step) +
           (side.has_null_lagrangian ? " layers " : " without null Lagrangian, layers ") +
           std::to_string(side.layers);
}

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

double widest_designed_angle(const DesignedSide& side) {
    return waves_for(side.task.reach).angles.back();
}

DesignedSide passive_side(const SideTask& model, const DesignProgress& progress) {
    const VectorFamily& family = find_vector_family(model.family);
    const PlaneLattice lattice = plane_lattice(family.describe(model.choice), model.g, 0);
    constexpr std::size_t wave_numbers = 32;
    const auto node = Eigen::Index(horizon_of(model.choice));
    const auto forces = Eigen::Index(lateral_chain(lattice, 0).reach());
    const EdgeReach reach{
        .node = node,
        .forces = forces,
        .layers = Eigen::Index(std::max(model.layers, least_side_layers(model.choice)))};
    const bool more = has_more_layers(reach);
    const Rational largest_beta =
        model.has_null_lagrangian ? family.largest_beta(model.choice) : Rational(0);
    EdgeTask task{.squares = EdgeSquares(
                      [&](unsigned layer, const Rational& beta) {
                          return family.at_edge(model.choice, layer, beta);
                      },
                      node, model.g, largest_beta),
                  .dimensions = 2,
                  .reach = reach,
                  .has_stabilisation = model.g != 0,
                  .largest_beta = largest_beta,
                  .near_the_lattice = more ? 0.2 : 0.03,
                  .light = more ? 0 : 1.0,
                  .long_steps = 10,
                  .stiff_steps = more ? 4U : 2U,
                  .starts = more ? std::vector<double>{1, 1. / 16, 16, 80} : std::vector<double>{1},
                  .evaluations = more ? 400 : 1000,
                  .highest_eigenvalue = highest_eigenvalue(lattice, wave_numbers),
                  .time_step = nearest_double(model.time_step)};
    return designed_side(std::move(task), weighted(waves_for(family, reach), lattice),
                         {lattice.speed_P, lattice.speed_S}, wave_numbers, progress);
}

std::optional<OppositeSide> free_opposite(const SideTask& model) {
    const VectorFamily& family = find_vector_family(model.family);
    if (family.at_edge == nullptr) {
        return std::nullopt;
    }
    const auto node = Eigen::Index(horizon_of(model.choice));
    const auto forces = Eigen::Index(
        lateral_chain(plane_lattice(family.describe(model.choice), model.g, 0), 0).reach());
    const EdgeSquares squares(
        [&](unsigned layer, const Rational& beta) {
            return family.at_edge(model.choice, layer, beta);
        },
        node, model.g, 0);
    return [=](double wave_number) {
        return StripSide(free_side(squares, node, forces, wave_number));
    };
}

std::vector<double> reflected_by_side(const SideTask& model, const DesignedSide& side,
                                      std::span<const double> degrees) {
    const PlaneLattice lattice =
        plane_lattice(find_vector_family(model.family).describe(model.choice), model.g, 0);
    const auto reflected = [&](bool is_P, double angle) {
        return reflected_by_edge(side.task, side.edge, wave_at(lattice, is_P, long_xi, angle));
    };
    std::vector<double> most;
    most.reserve(degrees.size());
    for (const double angle : degrees) {
        most.push_back(std::max(reflected(true, angle), reflected(false, angle)));
    }
    return most;
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
