// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen --check: is a folder of committed tables what the generator would write today?
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "generator/files.hpp"

namespace nmbcgen {

/// What differs from `fresh`, is missing or is left over in the folder, for people: one line a
/// file, with the changed lines where a file differs. Empty where the folder is up to date.
/// Tables outside the set that a user wrote there are compared with what their name asks for.
/// Throws FileError.
std::string staleness(const std::filesystem::path& folder, const std::vector<TextFile>& fresh);

}  // namespace nmbcgen
