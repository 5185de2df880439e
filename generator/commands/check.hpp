// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen --check: is a folder of committed tables what the generator would write today?
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "generator/support/files.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// Throws FileError where there is no such folder.
void require_folder(const std::filesystem::path& folder);

using MakeTable = std::function<Table(const Specification&)>;

/// What differs from `fresh`, is missing or is left over in the folder, for people: one line a
/// file, with the changed lines where a file differs. Empty where the folder is up to date.
/// Tables outside the set that a user wrote there are compared with what their name asks for, made
/// by `certified`. Throws FileError.
std::string staleness(const std::filesystem::path& folder, const std::vector<TextFile>& fresh,
                      const MakeTable& certified);

}  // namespace nmbcgen
