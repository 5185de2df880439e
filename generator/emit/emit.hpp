// SPDX-License-Identifier: GPL-2.0-or-later
/// Tables to text. An emitter writes what it is given and computes nothing but its layout and,
/// for a table at a fixed G, the rounded coefficients. Same table, same bytes.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "generator/table/table.hpp"

namespace nmbcgen {

/// Of the JSON: raised by any change that an old reader would misread.
inline constexpr int schema = 3;

/// Of the headers: nmbc::table_schema in runtime/nmbc/table.hpp.
inline constexpr int header_schema = 4;

/// FAMILY_nH[_w_PoQ_PoQ ..]_orderN[_sS][_tauPoQ][_dtPoQ][_at[pi]PoQxM ..][_GPoQ], the name of the
/// table and of its files.
std::string table_name(const Specification& specification);

/// The other way; nothing where it is no such name. Throws std::invalid_argument for a number that
/// parse_rational() refuses.
std::optional<Specification> specification_named(const std::string& name);

/// The wave number as on the command line: 6/5, pi, 2pi/3.
std::string to_string(const MatchingPoint& point);

/// All that is matched, as on the command line: 0:5,6/5:2.
std::string matching_text(const Specification& specification);

/// The command line that makes this table again.
std::string regenerating_command(const Specification& specification);

/// What one table can be written as.
struct Format {
    std::string_view name;    ///< on the command line
    std::string_view ending;  ///< of its files, with the point
    std::string (*emit)(const Table&);
};

/// All of them; the first is the usual one.
std::span<const Format> formats();

/// A C++20 header against runtime/nmbc/table.hpp.
std::string emit_header(const Table& table);

/// tables.hpp: includes the headers of all tables, and lists them in nmbc::generated::tables.
std::string emit_registry(std::span<const Table> tables);

/// One table as JSON, schema 3 (docs/json.md).
std::string emit_json(const Table& table);

/// A C99 header without anything else: at a fixed G its coefficients, else functions of G in
/// doubles, which lose digits near poles.
std::string emit_c(const Table& table);

/// symbol, damping, taylor, c and b, a coefficient a line: exact, and its double at a fixed G.
std::string emit_csv(const Table& table);

/// symbol, taylor, c and b as displayed formulas for a paper; needs amsmath.
std::string emit_latex(const Table& table);

/// A module of Python 3, standard library only, exact: fractions.Fraction.
std::string emit_python(const Table& table);

/// tables.json: {"schema": 3, "tables": [...]}.
std::string emit_json(std::span<const Table> tables);

}  // namespace nmbcgen
