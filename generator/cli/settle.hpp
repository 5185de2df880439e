// SPDX-License-Identifier: GPL-2.0-or-later
/// What can be told of a request only when the whole command line has been read.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "generator/cli/command_line.hpp"
#include "generator/cli/option_values.hpp"

namespace nmbcgen {

/// What becomes part of the request then.
struct Pending {
    std::optional<Matching> matching;
    std::optional<WeightChoice> weights;
};

/// Puts it there, and G = 0 where a command needs a G and the family has none.
/// Throws CLI::ParseError for options before a subcommand, a missing G or one that the family does
/// not have, as many weights as no horizon has, a limit that there is not, and the default folder
/// outside the project.
void settle(Request& request, const Pending& pending, const CLI::App& app);

}  // namespace nmbcgen
