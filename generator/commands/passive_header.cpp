// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/commands/passive.hpp"
#include "generator/exact/rational.hpp"
#include "generator/names/names.hpp"

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
    const PassiveSide side = passive_end(model);
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

}  // namespace nmbcgen
