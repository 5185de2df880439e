// SPDX-License-Identifier: GPL-2.0-or-later
/// The options of plane families.
#pragma once

#include <CLI/CLI.hpp>

#include "generator/cli/settle.hpp"

namespace nmbcgen {

/// That of the request's action.
std::string& family_of(Request& request);

/// Puts a plane family and its options into the request: for dispersion as they are, otherwise as
/// the name of a projected family, with its horizon. Takes the weights, which are those of bond
/// classes then. Throws CLI::ParseError where they do not fit the family, or there is no such
/// model.
void settle_plane(Request& request, Pending& pending, const CLI::App& used);

}  // namespace nmbcgen
