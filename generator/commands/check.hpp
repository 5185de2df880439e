// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen --check: is a folder of committed tables what the generator would write today?
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "generator/support/files.hpp"

namespace nmbcgen {

/// Throws FileError where there is no such folder.
void require_folder(const std::filesystem::path& folder);

/// What differs from `fresh` or is missing in the folder, for people: one line a file, with the
/// changed lines where a file differs. Empty where the folder is up to date. Throws FileError.
std::string staleness(const std::filesystem::path& folder, const std::vector<TextFile>& fresh);

/// The names of all other files in the folder, in order, with commas between. Throws FileError.
std::string other_files(const std::filesystem::path& folder, const std::vector<TextFile>& fresh);

}  // namespace nmbcgen
