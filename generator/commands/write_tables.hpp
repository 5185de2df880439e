// SPDX-License-Identifier: GPL-2.0-or-later
/// Tables of conditions on their way to files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "generator/support/files.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// derive() of each, with a line of progress where it takes seconds.
std::vector<Table> derived(const std::vector<Specification>& specifications);

/// Derives, proves and certifies, the last with what the cache knows.
std::vector<Table> certified(const std::vector<Specification>& specifications,
                             const std::optional<std::filesystem::path>& cache_folder);

/// The header that headers of this lattice's tables include.
TextFile lattice_file(const std::filesystem::path& folder, const Table& table);

/// The committed set: headers, tables.hpp and tables.json.
std::vector<TextFile> committed_files(const std::filesystem::path& folder,
                                      const std::optional<std::filesystem::path>& cache_folder);

/// Writes files and prints their names. Throws FileError.
void write_and_name(const std::vector<TextFile>& files);

/// Throws FileError where a table's name is too long for a file.
void require_short_name(const std::string& name);

}  // namespace nmbcgen
