// SPDX-License-Identifier: MIT
/// Tables to text. An emitter writes what it is given and computes nothing but its layout and,
/// for a table at a fixed G, the rounded coefficients. Same table, same bytes.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "generator/table/table.hpp"

namespace nmbcgen {

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

/// One table as JSON, schema 4 (docs/json.md).
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

/// tables.json: {"schema": 4, "tables": [...]}.
std::string emit_json(std::span<const Table> tables);

}  // namespace nmbcgen
