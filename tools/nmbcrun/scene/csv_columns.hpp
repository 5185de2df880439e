// SPDX-License-Identifier: MIT
/// Numbers from the CSV files that a scene names.
#pragma once

#include <filesystem>
#include <istream>
#include <string>
#include <vector>

namespace nmbcrun {

/// The columns of these names, in this order, and of the optional ones, which are empty where the
/// file has none, whatever others it has: a header line, then rows of numbers, separated by commas.
/// Empty lines, lines that begin with # and a byte order mark are left out.
/// Throws FileError where the file cannot be read, SceneError, with the line, where it has no such
/// column, a row is too short or longer than the header, an entry is no finite number, or there is
/// no row.
std::vector<std::vector<double>> read_columns(const std::filesystem::path& path,
                                              const std::vector<std::string>& names,
                                              const std::vector<std::string>& optional = {});

/// Likewise, of an open stream; name: for messages.
std::vector<std::vector<double>> read_columns(std::istream& stream, const std::string& name,
                                              const std::vector<std::string>& names,
                                              const std::vector<std::string>& optional = {});

}  // namespace nmbcrun
