// SPDX-License-Identifier: GPL-2.0-or-later
/// The way back: what a finished table says, as a reader sees it, into the generator's exact
/// data, and everything that can be verified about it there.
#pragma once

#include <nlohmann/json.hpp>
#include <nmbc/table.hpp>
#include <string>

#include "generator/table/table.hpp"

namespace nmbcgen::test {

using Json = nlohmann::ordered_json;

/// The table of a header, or one in JSON with its lattice, as nmbcrun reads it.
/// Throws std::exception where it is not in the one form that the generator writes.
Table read_table(const nmbc::MatchingTable& from);
Table read_table(const Json& from);

/// The i-th table of tables.json with its lattice in the place of its name.
Json with_lattice(const Json& file, std::size_t i);

/// What is wrong with a table, empty if nothing: it is read, proved by prove(), and compared
/// with the family it names; its name, source and proof must be those the generator gives.
std::string objection(const nmbc::MatchingTable& from);
std::string objection(const Json& from);

/// The whole tables.json.
std::string file_objection(const Json& file);

}  // namespace nmbcgen::test
