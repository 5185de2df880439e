// SPDX-License-Identifier: MIT
/// Text files: all or nothing.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "generator/support/posix_file.hpp"

namespace nmbcgen {

/// Characters of a file's name: file systems take 255, a temporary file some more than its own.
inline constexpr std::size_t longest_name = 200;

struct TextFile {
    std::filesystem::path path;
    std::string text;
};

/// Writes files of one folder, which is made where it is missing. Each goes to a temporary
/// neighbour first, and none takes its own name before all are on disk, so a full disk or a folder
/// that cannot be written leaves what was there. Throws FileError.
void write_files(const std::vector<TextFile>& files);

/// The file's text; none where there is no such file. Throws FileError where it cannot be read.
std::optional<std::string> read_file(const std::filesystem::path& path);

/// Prints to standard output and makes sure it arrived. Throws FileError.
void print(const std::string& text);

}  // namespace nmbcgen
