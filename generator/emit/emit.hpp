// SPDX-License-Identifier: GPL-2.0-or-later
/// Tables to text. An emitter writes what it is given and computes nothing but its layout and,
/// for a table at a fixed G, the rounded coefficients. Same table, same bytes.
#pragma once

#include <span>
#include <string>

#include "generator/table/table.hpp"

namespace nmbcgen {

/// Of the JSON: raised by any change that an old reader would misread.
inline constexpr int schema = 3;

/// Of the headers: nmbc::table_schema in runtime/nmbc/table.hpp.
inline constexpr int header_schema = 4;

/// FAMILY_nH_orderN[_sS][_tauPoQ][_dtPoQ][_GPoQ], the name of the table and of its files.
std::string table_name(const Specification& specification);

/// The command line that makes this table again.
std::string regenerating_command(const Specification& specification);

/// A C++20 header against runtime/nmbc/table.hpp.
std::string emit_header(const Table& table);

/// tables.hpp: includes the headers of all tables, and lists them in nmbc::generated::tables.
std::string emit_registry(std::span<const Table> tables);

/// One table as JSON, schema 3 (docs/json.md).
std::string emit_json(const Table& table);

/// tables.json: {"schema": 3, "tables": [...]}.
std::string emit_json(std::span<const Table> tables);

}  // namespace nmbcgen
