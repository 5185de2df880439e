// SPDX-License-Identifier: GPL-2.0-or-later
/// Subcommands that answer questions about boundaries and lattices.
#pragma once

#include <CLI/CLI.hpp>

#include "generator/cli/command_line.hpp"
#include "generator/cli/settle.hpp"

namespace nmbcgen {

/// nmbcgen reflect, with the same options for the condition.
CLI::App* add_reflect(CLI::App& app, Request& request, Pending& pending);
/// nmbcgen prove, of what is not damped.
CLI::App* add_prove(CLI::App& app, Request& request, Pending& pending);
/// nmbcgen dispersion.
CLI::App* add_dispersion(CLI::App& app, Curves& curves, Pending& pending);
/// nmbcgen passive.
CLI::App* add_passive(CLI::App& app, Request& request, Pending& pending);
/// nmbcgen recommend.
CLI::App* add_recommend(CLI::App& app, Request& request, Pending& pending);
/// nmbcgen optimise, with the same options for the condition but --match.
CLI::App* add_optimise(CLI::App& app, Request& request, Pending& pending);
/// nmbcgen closed-forms.
CLI::App* add_closed_forms(CLI::App& app, Request& request);

}  // namespace nmbcgen
