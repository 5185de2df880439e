// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/closure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "generator/closures/surface_node.hpp"
#include "generator/exact/rational.hpp"

namespace nmbcgen {
namespace {

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

}  // namespace

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
    using Json = nlohmann::ordered_json;
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

}  // namespace nmbcgen
