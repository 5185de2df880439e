// SPDX-License-Identifier: GPL-2.0-or-later
/// Options that say which lattice model of a family is meant.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "generator/cli/settle.hpp"

namespace nmbcgen {

/// --radius2, which is returned, and what goes with it.
CLI::Option* add_plane_model(CLI::App& app, PlaneOptions& plane);

/// Likewise, with --polarisation.
CLI::Option* add_plane(CLI::App& app, PlaneOptions& plane);

CLI::Option* add_weights(CLI::App& app, std::optional<WeightChoice>& weights);

}  // namespace nmbcgen
