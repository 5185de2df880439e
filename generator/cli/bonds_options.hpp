// SPDX-License-Identifier: GPL-2.0-or-later
/// The options of nmbcgen bonds.
#pragma once

#include <CLI/CLI.hpp>

#include "generator/cli/command_line.hpp"

namespace nmbcgen {

CLI::App* add_bonds(CLI::App& app, Request& request);

}  // namespace nmbcgen
