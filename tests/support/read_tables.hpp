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

/// The table of a header, or one element of "tables" in tables.json.
/// Throws std::runtime_error where the text is not in the one form it has to have: integers
/// without leading zeros, lowest terms, positive leading denominator, a known set of keys.
Table read_table(const nmbc::MatchingTable& from);
Table read_table(const Json& from);

/// What is wrong with a table, empty if nothing: it is read, proved by prove(), and compared
/// with the family it names; its name, source and proof must be those the generator gives.
std::string objection(const nmbc::MatchingTable& from);
std::string objection(const Json& from);

/// The whole tables.json.
std::string file_objection(const Json& file);

}  // namespace nmbcgen::test
