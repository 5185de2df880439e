// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/passive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"
#include "generator/families/projected.hpp"
#include "generator/lattice/projection.hpp"
#include "generator/pipeline.hpp"

namespace nmbcgen {
namespace {

std::vector<WeightedWave> designed_waves(const PlaneLattice& lattice) {
    std::vector<WeightedWave> waves;
    for (const double angle : {0.0, 15.0, 30.0, 45.0, widest_designed_angle}) {
        for (const double xi : {0.05, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0}) {
            for (const bool is_P : {true, false}) {
                const ArrivingWave wave = wave_at(lattice, is_P, xi, angle);
                const PlaneMode& mode = wave.outgoing[std::size_t(wave.column)];
                // Where waves stand, or go backwards, their angle is not that of their energy.
                const double slow = 0.2 * (is_P ? lattice.speed_P : lattice.speed_S);
                if (mode.group_velocity > slow) {
                    waves.push_back({wave, 1 / std::sqrt(xi)});
                }
            }
        }
    }
    return waves;
}

using Json = nlohmann::ordered_json;

Json strings(const std::vector<Rational>& values) {
    Json list = Json::array();
    for (const Rational& value : values) {
        list.push_back(to_string(value));
    }
    return list;
}

Json reflections(const PlaneLattice& lattice, const PassiveSide& side) {
    Json list = Json::array();
    for (const double angle : {0.0, 20.0, 40.0, 60.0, 70.0, 80.0}) {
        for (const double xi : {0.05, 0.1, 0.2, 0.5, 1.0}) {
            const auto reflected = [&](bool is_P) {
                return reflected_by_edge(side.task, side.edge, wave_at(lattice, is_P, xi, angle));
            };
            list.push_back(
                {{"angle", angle}, {"xi", xi}, {"P", reflected(true)}, {"S", reflected(false)}});
        }
    }
    return list;
}

Json numbers_of(const PassiveDesign& design) {
    Json factors = Json::array();
    for (const auto& factor : design.factor) {
        Json rows = Json::array();
        for (const auto& row : factor) {
            rows.push_back(strings(row));
        }
        factors.push_back(rows);
    }
    Json masses = Json::array();
    for (const auto& mass : design.mass) {
        masses.push_back(strings(mass));
    }
    return {{"layers", design.strain.size()},
            {"strain_weights", strings(design.strain)},
            {"stabilisation_weights", strings(design.stabilisation)},
            {"masses", masses},
            {"dashpot_factors", factors},
            {"dashpot_scales", strings(design.scale)}};
}

std::vector<double> symbol_at(const ChainModel& model) {
    std::vector<double> symbol;
    for (const Polynomial& entry : make_model("nopd1d", model.horizon).symbol) {
        symbol.push_back(nearest_double(evaluate(entry, model.G)));
    }
    return symbol;
}

NoSuchBoundary no_design(const std::string& at, const std::domain_error& reason) {
    return NoSuchBoundary(fmt::format("no passive design was found at {}: {}", at, reason.what()));
}

}  // namespace

ArrivingWave wave_at(const PlaneLattice& lattice, bool is_P, double xi, double degrees) {
    try {
        return arriving_wave(lattice, is_P, xi, degrees * std::numbers::pi / 180);
    } catch (const std::domain_error& error) {
        throw NoSuchBoundary(fmt::format("{} waves of xi = {:g}/dX at {:g} degrees: {}",
                                         is_P ? "P" : "S", xi, degrees, error.what()));
    }
}

PassiveSide passive_side(const PlaneModel& model) {
    const VectorFamily& family = find_vector_family(model.family);
    const PlaneLattice lattice = plane_lattice(family.describe(model.choice), model.g, 0);
    constexpr std::size_t wave_numbers = 32;
    const auto node = Eigen::Index(horizon_of(model.choice));
    const auto forces = Eigen::Index(lateral_chain(lattice, 0).reach());
    const Rational largest_beta = family.largest_beta(model.choice);
    EdgeTask task{.squares = EdgeSquares(
                      [&](unsigned layer, const Rational& beta) {
                          return family.at_edge(model.choice, layer, beta);
                      },
                      node, model.g, largest_beta),
                  .dimensions = 2,
                  .reach = {.node = node, .forces = forces, .layers = 2 * node},
                  .has_stabilisation = model.g != 0,
                  .largest_beta = largest_beta,
                  .highest_eigenvalue = highest_eigenvalue(lattice, wave_numbers),
                  .time_step = nearest_double(model.time_step)};
    try {
        return designed_side(std::move(task), designed_waves(lattice),
                             {lattice.speed_P, lattice.speed_S}, wave_numbers);
    } catch (const std::domain_error& error) {
        throw no_design("g = " + to_string(model.g), error);
    }
}

PassiveSide passive_end(const ChainModel& model) {
    try {
        return passive_end(
            symbol_at(model), model.horizon, model.G,
            [&](unsigned layer) { return nopd1d_at_edge(model.horizon, layer); },
            nearest_double(model.time_step));
    } catch (const std::domain_error& error) {
        throw no_design("G = " + to_string(model.G), error);
    }
}

std::string passive_json(const PlaneModel& model) {
    const PassiveSide side = passive_side(model);
    const VectorModel described = find_vector_family(model.family).describe(model.choice);
    const PlaneLattice lattice = plane_lattice(described, model.g, 0);
    Json all{
        {"boundary", "passive"},
        {"family", model.family},
        {"model", described.description},
        {"source", described.source},
        {"g", to_string(model.g)},
        {"time_step", to_string(model.time_step)},
        {"units",
         "dX, density and Young's modulus are 1; side x = const, layers from the edge "
         "inwards, components x and y"},
    };
    all.update(numbers_of(side.design));
    all.update(
        Json{{"dashpot_speeds_squared", Json::array({to_string(speed_squared(described, 0)[0]),
                                                     to_string(speed_squared(described, 1)[0])})},
             {"null_lagrangian", to_string(side.design.null_lagrangian)},
             {"proved", "weights and masses are positive, 0 <= null_lagrangian <= " +
                            to_string(side.task.largest_beta) +
                            ", dashpots are speed times L L^T over their scale: the energy of a "
                            "body with this straight "
                            "side is a sum of squares, which the side's dashpots never raise"},
             {"designed_up_to_degrees", widest_designed_angle},
             {"highest_eigenvalue_interior", side.task.highest_eigenvalue},
             {"highest_eigenvalue", side.highest_eigenvalue},
             {"reflected_energy", reflections(lattice, side)}});
    return all.dump(2) + "\n";
}

std::string passive_json(const ChainModel& model) {
    const PassiveSide side = passive_end(model);
    const Model described = make_model("nopd1d", model.horizon);
    const LateralChain chain = chain_of(symbol_at(model));
    Json reflections = Json::array();
    for (const double xi : {0.05, 0.1, 0.2, 0.5, 1.0}) {
        reflections.push_back(
            {{"xi", xi},
             {"energy", reflected_by_edge(side.task, side.edge, arriving_wave(chain, xi))}});
    }
    Json all{{"boundary", "passive"},
             {"family", "nopd1d"},
             {"horizon", model.horizon},
             {"model", described.description},
             {"source", described.source},
             {"G", to_string(model.G)},
             {"time_step", to_string(model.time_step)},
             {"units", "dX = c = density = 1; layers from the end inwards"}};
    all.update(numbers_of(side.design));
    all.update(Json{{"proved",
                     "weights, masses and scales are positive, dashpots are L L^T over "
                     "their scale: the energy of a chain with this end is a sum of "
                     "squares, which its dashpots never raise"},
                    {"highest_eigenvalue_interior", side.task.highest_eigenvalue},
                    {"highest_eigenvalue", side.highest_eigenvalue},
                    {"reflected_energy", reflections}});
    return all.dump(2) + "\n";
}

}  // namespace nmbcgen
