// SPDX-License-Identifier: GPL-2.0-or-later
/// Options that say which condition of which lattice is meant.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "generator/cli/command_line.hpp"
#include "generator/cli/settle.hpp"

namespace nmbcgen {

struct SpecificationOptions {
    CLI::Option* family;
    CLI::Option* order;
    CLI::Option* match;
    CLI::Option* horizon;
    CLI::Option* radius;
    CLI::Option* weights;
    CLI::Option* stride;
    CLI::Option* damping;
    CLI::Option* time_step;
    CLI::Option* cfl;
    CLI::Option* G;
};

SpecificationOptions add_specification(CLI::App& app, Request& request, Pending& pending);

/// Throws CLI::RequiredError where no condition is given, and names what it could be, or otherwise.
void require_condition(const SpecificationOptions& options, const std::string& otherwise);

/// The size of the neighbourhood, of a chain or of a plane lattice.
void require_one_of(CLI::App& app, CLI::Option* horizon, CLI::Option* radius);

}  // namespace nmbcgen
