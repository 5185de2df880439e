// SPDX-License-Identifier: GPL-2.0-or-later
/// The options of commands that print coefficients as text or JSON.
#pragma once

#include <CLI/CLI.hpp>

#include "generator/cli/command_line.hpp"
#include "generator/cli/settle.hpp"

namespace nmbcgen {

/// --format, and --stdout.
CLI::Option* add_format(CLI::App& command, Request& request);

CLI::App* add_bonds(CLI::App& app, Request& request);
CLI::App* add_closure(CLI::App& app, Request& request);
CLI::App* add_coupling(CLI::App& app, Request& request);
CLI::App* add_influence(CLI::App& app, Request& request);
CLI::App* add_taylor(CLI::App& app, Request& request, Pending& pending);
CLI::App* add_oblique(CLI::App& app, Request& request, Pending& pending);

}  // namespace nmbcgen
