// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/closure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "generator/closures/summation_by_parts.hpp"
#include "generator/closures/surface_node.hpp"
#include "generator/exact/rational.hpp"
#include "generator/families/family.hpp"

namespace nmbcgen {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* method = "surface node method (SNM 2023), (2), (4), (5)";
constexpr const char* units =
    "dX = E = density = 1; nodes at 1/2, 3/2, .. from the surface, displacements outwards";

std::vector<std::string> texts_of(const std::vector<Rational>& numbers) {
    std::vector<std::string> texts;
    texts.reserve(numbers.size());
    for (const Rational& number : numbers) {
        texts.push_back(to_string(number));
    }
    return texts;
}

/// w_k of bond1d.
std::vector<Rational> weights_of(const SurfaceNode& node) {
    std::vector<Rational> weights;
    for (std::size_t k = 1; k <= node.quadrature.size(); ++k) {
        weights.push_back(node.quadrature[k - 1] / k);
    }
    return weights;
}

std::string surface_node_text(const ClosureTask& task) {
    const SurfaceNode node = surface_node(task.horizon, task.corrected);
    return fmt::format(
        "closure     {}\nunits       {}\nquadrature  beta_k = {}{}\nghosts      u_f = 2f u_s - (2f "
        "- "
        "1) u_1, f = 1 .. {}\ndirichlet   u_s as given\nneumann     u_s = sum row_i u_i + load e, "
        "e the "
        "strain of the traction; free: e = 0\nrow         {}\nload        {}\noptions     --family "
        "bond1d "
        "--horizon {} --weights {}\n",
        method, units, fmt::join(texts_of(node.quadrature), ", "),
        task.corrected ? ", corrected" : ", as printed", task.horizon,
        fmt::join(texts_of(node.row), ", "), to_string(node.load), task.horizon,
        fmt::join(texts_of(weights_of(node)), ","));
}

std::string surface_node_json(const ClosureTask& task) {
    const SurfaceNode node = surface_node(task.horizon, task.corrected);
    Json ghosts = Json::array();
    for (const std::vector<Rational>& ghost : node.ghosts) {
        ghosts.push_back(texts_of(ghost));
    }
    const Json all{{"closure", task.method},
                   {"horizon", task.horizon},
                   {"corrected", task.corrected},
                   {"source", method},
                   {"units", units},
                   {"quadrature", texts_of(node.quadrature)},
                   {"bond1d_weights", texts_of(weights_of(node))},
                   {"ghosts", ghosts},
                   {"row", texts_of(node.row)},
                   {"load", to_string(node.load)}};
    return all.dump(2) + "\n";
}

constexpr const char* parts_method =
    "summation by parts: V D = Q, Q + Q^T = diag(-1, 0, .., 0, 1), Q 1 = 0, Q x = V 1";
constexpr const char* parts_units = "dX = E = density = 1; node 0 is on the surface";
constexpr const char* parts_choice =
    "least sum of squares of Q_ij - inside_(j-i) between the n outermost nodes";

SummationByParts parts_of(const ClosureTask& task) {
    try {
        return summation_by_parts(task.weights);
    } catch (const std::domain_error& reason) {
        throw NoSuchModel(fmt::format("summation by parts with these weights: {}", reason.what()));
    }
}

std::string summation_by_parts_text(const ClosureTask& task) {
    const SummationByParts parts = parts_of(task);
    std::string text = fmt::format(
        "closure     {}\nunits       {}\nchoice      {}\ninside      Q_i,i+k = -Q_i,i-k = {}\n"
        "volumes     {}\nneumann     V_0 u_0'' = .. + t at x = 0, t the traction\n"
        "dirichlet   u_0 as given\n",
        parts_method, parts_units, parts_choice, fmt::join(texts_of(parts.inside), ", "),
        fmt::join(texts_of(parts.volumes), ", "));
    for (std::size_t node = 0; node < parts.rows.size(); ++node) {
        text += fmt::format("Q_{:<9} {}\n", node, fmt::join(texts_of(parts.rows[node]), ", "));
    }
    return text + fmt::format("options     --family nopd1d --horizon {} --weights {}\n",
                              task.horizon, fmt::join(texts_of(task.weights), ","));
}

std::string summation_by_parts_json(const ClosureTask& task) {
    const SummationByParts parts = parts_of(task);
    Json rows = Json::array();
    for (const std::vector<Rational>& row : parts.rows) {
        rows.push_back(texts_of(row));
    }
    const Json all{{"closure", task.method},
                   {"horizon", task.horizon},
                   {"weights", texts_of(task.weights)},
                   {"source", parts_method},
                   {"choice", parts_choice},
                   {"units", parts_units},
                   {"inside", texts_of(parts.inside)},
                   {"volumes", texts_of(parts.volumes)},
                   {"rows", rows}};
    return all.dump(2) + "\n";
}

}  // namespace

std::string closure_text(const ClosureTask& task) {
    return task.method == "snm" ? surface_node_text(task) : summation_by_parts_text(task);
}

std::string closure_json(const ClosureTask& task) {
    return task.method == "snm" ? surface_node_json(task) : summation_by_parts_json(task);
}

}  // namespace nmbcgen
