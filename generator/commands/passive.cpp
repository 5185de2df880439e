// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/passive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"
#include "generator/families/vector_family.hpp"
#include "generator/lattice/projection.hpp"
#include "generator/pipeline.hpp"

namespace nmbcgen {
namespace {

using Json = nlohmann::ordered_json;

Json strings(const std::vector<Rational>& values) {
    Json list = Json::array();
    for (const Rational& value : values) {
        list.push_back(to_string(value));
    }
    return list;
}

Json reflections(const PlaneLattice& lattice, const DesignedSide& side) {
    Json list = Json::array();
    for (const double angle :
         {0.0, 10.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0, 50.0, 60.0, 70.0, 80.0}) {
        for (const double xi : {0.05, 0.1, 0.2, 0.5, 1.0}) {
            const auto reflected = [&](bool is_P) -> Json {
                const auto wave = told_wave(lattice, is_P, xi, angle);
                return wave ? Json(reflected_by_edge(side.task, side.edge, *wave)) : Json();
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
    for (const Polynomial& entry : make_model(model.family, model.horizon).symbol) {
        symbol.push_back(nearest_double(evaluate(entry, model.G)));
    }
    return symbol;
}

/// Of the chain of atoms: an end with |R| ~ xi^4 in closed form. Beyond node 1 all is the chain's.
Json closed_form() {
    return {{"layers", 2},
            {"closed_form",
             {{"x", "(3 - sqrt(5))/2"},
              {"bond", "k = sqrt(8 (sqrt(5) - 2)), between the outermost node and the next one"},
              {"masses", Json::array({"x/k", "1/2 + (1 - x)/k"})},
              {"dashpot", "1, on the outermost node"}}}};
}

NoSuchBoundary no_design(const std::string& at, const std::domain_error& reason) {
    return NoSuchBoundary(fmt::format("no passive design was found at {}: {}", at, reason.what()));
}

}  // namespace

std::optional<ArrivingWave> told_wave(const PlaneLattice& lattice, bool is_P, double xi,
                                      double degrees) {
    try {
        return wave_at(lattice, is_P, xi, degrees);
    } catch (const std::domain_error&) {
        return std::nullopt;
    }
}

DesignedSide designed(const SideTask& model, const DesignProgress& progress) {
    try {
        return passive_side(model, progress);
    } catch (const std::domain_error& error) {
        throw no_design("g = " + to_string(model.g), error);
    }
}

DesignedSide passive_end(const ChainModel& model) {
    if (model.family == "chain1d") {
        return atom_chain_end();
    }
    try {
        return passive_end(
            symbol_at(model), model.horizon, model.G,
            [&](unsigned layer) { return nopd1d_at_edge(model.horizon, layer); },
            nearest_double(model.time_step));
    } catch (const std::domain_error& error) {
        throw no_design("G = " + to_string(model.G), error);
    }
}

std::string passive_json(const SideTask& model, const DesignProgress& progress) {
    const DesignedSide side = designed(model, progress);
    const VectorModel described = find_vector_family(model.family).describe(model.choice);
    const PlaneLattice lattice = plane_lattice(described, model.g, 0);
    Json all{
        {"boundary", "passive"},
        {"family", model.family},
        {"model", described.description},
        {"source", described.source},
        {"g", to_string(model.g)},
        {"time_step", to_string(model.time_step)},
        {"units", std::string(find_vector_family(model.family).has_weights
                                  ? "dX and density are 1, the modulus is what the weights make"
                                  : "dX, density and Young's modulus are 1") +
                      "; side x = const, layers from the edge inwards, components x and y"},
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
             {"designed_up_to_degrees", widest_designed_angle(side)},
             {"highest_eigenvalue_interior", side.task.highest_eigenvalue},
             {"highest_eigenvalue", side.eigenvalue_bound()},
             {"reflected_energy", reflections(lattice, side)}});
    return all.dump(2) + "\n";
}

std::string passive_json(const ChainModel& model) {
    const DesignedSide side = passive_end(model);
    const Model described = make_model(model.family, model.horizon);
    const LateralChain chain = chain_of(symbol_at(model));
    Json reflections = Json::array();
    for (const double xi : {0.05, 0.1, 0.2, 0.5, 1.0}) {
        reflections.push_back(
            {{"xi", xi},
             {"energy", reflected_by_edge(side.task, side.edge, arriving_wave(chain, xi))}});
    }
    Json all{{"boundary", "passive"},
             {"family", model.family},
             {"horizon", model.horizon},
             {"model", described.description},
             {"source", described.source},
             {"G", to_string(model.G)},
             {"time_step", to_string(model.time_step)},
             {"units", "dX = c = density = 1; layers from the end inwards"}};
    const bool is_closed = side.design.strain.empty();
    all.update(is_closed ? closed_form() : numbers_of(side.design));
    all.update(
        Json{{"proved", std::string(is_closed ? "bonds and masses are positive, the dashpot, too"
                                              : "weights, masses and scales are positive, dashpots "
                                                "are L L^T over their scale") +
                            ": the energy of a chain with this end is a sum of squares, which its "
                            "dashpots never raise"},
             {"highest_eigenvalue_interior", side.task.highest_eigenvalue},
             {"highest_eigenvalue", side.eigenvalue_bound()},
             {"reflected_energy", reflections}});
    return all.dump(2) + "\n";
}

}  // namespace nmbcgen
