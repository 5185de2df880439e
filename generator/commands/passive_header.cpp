// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <numbers>
#include <string_view>

#include "generator/commands/passive.hpp"
#include "generator/exact/rational.hpp"
#include "generator/names/names.hpp"
#include "generator/names/projected_family.hpp"

namespace nmbcgen {
namespace {

/// Rows of a matrix, or one row, to the last digit.
std::string rows_of(const std::vector<double>& entries, std::size_t columns) {
    std::string text;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        text += fmt::format("{}{:.17g}",
                            i == 0             ? ""
                            : i % columns == 0 ? ",\n     "
                                               : ", ",
                            entries[i]);
    }
    return text;
}

}  // namespace

std::string passive_header(const ChainModel& model) {
    const DesignedSide side = passive_end(model);
    const nmbc::PassiveEnd end = for_runtime(side, side.task.at(0));
    const std::string name =
        fmt::format("passive_nopd1d_n{}_G{}{}", model.horizon, p_over_q(model.G),
                    model.time_step == 0 ? "" : "_dt" + p_over_q(model.time_step));
    return fmt::format(
        "// SPDX-License-Identifier: MIT\n"
        "// Made by nmbcgen passive --horizon {1} --G {2}{3} --header\n"
        "#pragma once\n\n"
        "#include <nmbc/passive.hpp>\n\n"
        "namespace nmbc::generated {{\n\n"
        "/// A passive end of nopd1d, n = {1}, G = {2}, designed for {4}.\n"
        "inline const PassiveEnd {0}{{\n"
        "    .rows = {5},\n"
        "    .stiffness =\n    {{{6}}},\n"
        "    .mass =\n    {{{7}}},\n"
        "    .dashpots =\n    {{{8}}},\n"
        "    .highest_eigenvalue = {9:.17g},\n"
        "    .further = {10}}};\n\n"
        "}}  // namespace nmbc::generated\n",
        name, model.horizon, to_string(model.G),
        model.time_step == 0 ? "" : " --time-step " + to_string(model.time_step),
        model.time_step == 0 ? "short steps" : "steps of " + to_string(model.time_step) + " dX/c",
        end.rows, rows_of(end.stiffness, end.stiffness.size() / end.rows),
        rows_of(end.mass, end.mass.size()), rows_of(end.dashpots, end.mass.size()),
        end.highest_eigenvalue, end.further);
}

std::string passive_header(const SideTask& model) {
    const nmbc::PassiveSide side = for_runtime(designed(model));
    const std::size_t layers = side.strain.size();
    const VectorChoice& choice = model.choice;
    std::string lattice =
        name_of({.family = model.family, .model = choice, .polarisation = Polarisation::P});
    lattice.resize(lattice.size() - std::string_view("_P").size());
    std::string name = "passive_" + lattice;
    std::string options = fmt::format("--radius2 {}", choice.radius_squared);
    std::string made_for;
    if (model.family == "bond2d") {
        std::string exact;
        for (const Rational& weight : choice.weights) {
            exact += (exact.empty() ? "" : ",") + to_string(weight);
            made_for +=
                fmt::format("{}{:.17g}", made_for.empty() ? "" : ", ", nearest_double(weight));
        }
        options += " --weights " + exact;
        made_for = fmt::format("bond2d({}, {{{}}})", choice.radius_squared, made_for);
    } else {
        const std::string state = choice.plane_strain ? "strain" : "stress";
        const Rational nu = choice.poisson.value_or(0);
        name += "_g" + p_over_q(model.g);
        options +=
            fmt::format(" --nu {} --state {} --G {}", to_string(nu), state, to_string(model.g));
        made_for = fmt::format("nopd2d({}, {:.17g}, {:.17g}, StressState::plane_{})",
                               choice.radius_squared, nearest_double(nu),
                               nearest_double(model.g) * std::numbers::pi, state);
    }
    if (model.time_step != 0) {
        name += "_dt" + p_over_q(model.time_step);
        options += " --time-step " + to_string(model.time_step);
    }
    return fmt::format(
        "// SPDX-License-Identifier: MIT\n"
        "// Made by nmbcgen passive --family {1} {2} --header\n"
        "// clang-format off\n"
        "#pragma once\n\n"
        "#include <nmbc/plane_sides.hpp>\n\n"
        "namespace nmbc::generated {{\n\n"
        "/// A passive side of the lattice that it was made for.\n"
        "inline const PassiveSide {0}{{\n"
        "    .strain = {{{3}}},\n"
        "    .stabilisation = {{{4}}},\n"
        "    .mass = {{std::vector<double>{{{5}}},\n             {{{6}}}}},\n"
        "    .dashpots = {{std::vector<double>\n    {{{7}}},\n    {{{8}}}}},\n"
        "    .null_lagrangian = {9:.17g},\n"
        "    .made_for = {10}}};\n\n"
        "}}  // namespace nmbc::generated\n",
        name, model.family, options, rows_of(side.strain, layers),
        rows_of(side.stabilisation, layers), rows_of(side.mass[0], layers),
        rows_of(side.mass[1], layers), rows_of(side.dashpots[0], layers),
        rows_of(side.dashpots[1], layers), side.null_lagrangian, made_for);
}

}  // namespace nmbcgen
