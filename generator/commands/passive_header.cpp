// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numbers>
#include <string>
#include <string_view>
#include <vector>

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

/// A header of one object. options: behind nmbcgen passive; type: of the runtime, which `include`
/// has; about: what it is, a sentence; members: `.NAME = VALUE`.
std::string header_of(std::string_view options, std::string_view include, std::string_view about,
                      std::string_view type, std::string_view name,
                      const std::vector<std::string>& members) {
    return fmt::format(
        "// SPDX-License-Identifier: MIT\n"
        "// Made by nmbcgen passive {} --header\n"
        "// clang-format off\n"
        "#pragma once\n\n"
        "#include <nmbc/{}>\n\n"
        "namespace nmbc::generated {{\n\n"
        "/// {}\n"
        "inline const {} {}{{\n    {}}};\n\n"
        "}}  // namespace nmbc::generated\n",
        options, include, about, type, name, fmt::join(members, ",\n    "));
}

std::string step_option(const Rational& step) {
    return step == 0 ? "" : " --time-step " + to_string(step);
}

std::string step_name(const Rational& step) {
    return step == 0 ? "" : "_dt" + p_over_q(step);
}

}  // namespace

std::string passive_header(const ChainModel& model) {
    const DesignedSide side = passive_end(model);
    const nmbc::PassiveEnd end = for_runtime(side, side.task.at(0));
    const std::string made_for = model.time_step == 0
                                     ? "short steps"
                                     : fmt::format("steps of {} dX/c", to_string(model.time_step));
    const bool is_closed = model.family == "chain1d";
    return header_of(
        is_closed ? "--family chain1d --horizon 1"
                  : fmt::format("--horizon {} --G {}{}", model.horizon, to_string(model.G),
                                step_option(model.time_step)),
        "passive.hpp",
        is_closed ? "A passive end of the chain of atoms, chain1d, |R| ~ xi^4, in closed form."
                  : fmt::format("A passive end of nopd1d, n = {}, G = {}, designed for {}.",
                                model.horizon, to_string(model.G), made_for),
        "PassiveEnd",
        is_closed ? "passive_chain1d"
                  : fmt::format("passive_nopd1d_n{}_G{}{}", model.horizon, p_over_q(model.G),
                                step_name(model.time_step)),
        {fmt::format(".rows = {}", end.rows),
         fmt::format(".stiffness =\n    {{{}}}",
                     rows_of(end.stiffness, end.stiffness.size() / end.rows)),
         fmt::format(".mass =\n    {{{}}}", rows_of(end.mass, end.mass.size())),
         fmt::format(".dashpots =\n    {{{}}}", rows_of(end.dashpots, end.mass.size())),
         fmt::format(".highest_eigenvalue = {:.17g}", end.highest_eigenvalue),
         fmt::format(".further = {}", end.further)});
}

std::string passive_header(const SideTask& model, const DesignProgress& progress) {
    const nmbc::PassiveSide side = for_runtime(designed(model, progress));
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
    std::string layers_name;
    std::string layers_option;
    if (model.layers != 0) {
        layers_name = fmt::format("_q{}", layers);
        layers_option = fmt::format(" --layers {}", layers);
    }
    return header_of(
        fmt::format("--family {} {}{}", model.family, options,
                    step_option(model.time_step) + layers_option),
        "plane_sides.hpp", "A passive side of the lattice that it was made for.", "PassiveSide",
        name + step_name(model.time_step) + layers_name,
        {fmt::format(".strain = {{{}}}", rows_of(side.strain, layers)),
         fmt::format(".stabilisation = {{{}}}", rows_of(side.stabilisation, layers)),
         fmt::format(".mass = {{std::vector<double>{{{}}},\n             {{{}}}}}",
                     rows_of(side.mass[0], layers), rows_of(side.mass[1], layers)),
         fmt::format(".dashpots = {{std::vector<double>\n    {{{}}},\n    {{{}}}}}",
                     rows_of(side.dashpots[0], layers), rows_of(side.dashpots[1], layers)),
         fmt::format(".null_lagrangian = {:.17g}", side.null_lagrangian),
         fmt::format(".made_for = {}", made_for)});
}

}  // namespace nmbcgen
