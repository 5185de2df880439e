// SPDX-License-Identifier: MIT
/// Files that a scene names.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>

namespace nmbcrun {

/// Opens a file for reading, a regular one, since others such as /dev/zero need have no end.
/// Throws FileError where it is none or cannot be read, SceneError where it has more than so many
/// bytes.
std::ifstream open_regular_file(const std::filesystem::path& path, std::uintmax_t most_bytes);

}  // namespace nmbcrun
