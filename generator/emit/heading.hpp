// SPDX-License-Identifier: MIT
/// The comment that a table begins with, in every format that has comments.
#pragma once

#include <string>

#include "generator/table/table.hpp"

namespace nmbcgen {

/// Licence, version and the command that makes the file again, each on a line of its own that
/// begins with `comment`.
std::string banner(const std::string& comment, const std::string& command);

/// The banner with the table's own command, then its model, sources, units and signs, what is
/// proved of it and how its certificate is meant. options: of the command, such as " --format c".
std::string heading(const std::string& comment, const Table& table, const std::string& options);

/// "NMBC2, horizon 1 dX, stride 1", with tau, time step and G where they are given.
std::string title(const Specification& what);

}  // namespace nmbcgen
