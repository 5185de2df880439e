// SPDX-License-Identifier: GPL-2.0-or-later
/// What can be told of a request only when the whole command line has been read.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "generator/cli/command_line.hpp"
#include "generator/cli/option_values.hpp"
#include "generator/names/projected_family.hpp"

namespace nmbcgen {

/// A plane family and which of its waves, in place of a horizon.
struct PlaneOptions {
    std::optional<unsigned> radius_squared;
    std::optional<Rational> poisson;
    std::optional<bool> plane_strain;
    std::optional<Polarisation> polarisation;
    std::optional<std::vector<double>> angles;  ///< of dispersion
};

/// What becomes part of the request then.
struct Pending {
    PlaneOptions plane;
    std::optional<Matching> matching;
    std::optional<WeightChoice> weights;
    // Of nmbcgen passive:
    Rational passive_step = 0;
    std::optional<unsigned> layers{};
};

/// Puts it there, and G = 0 where a command needs a G and the family has none.
/// Throws CLI::ParseError for options before a subcommand, a missing G or one that the family does
/// not have, as many weights as no horizon has, a limit that there is not, and the default folder
/// outside the project, and where the options of plane families do not fit the family.
void settle(Request& request, Pending pending, const CLI::App& app);

}  // namespace nmbcgen
