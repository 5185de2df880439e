// SPDX-License-Identifier: MIT
/// Temporary files of processes that were killed.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace nmbcrun {

/// Whether the file can be read and its first bytes are these.
bool begins_with(const std::filesystem::path& path, std::string_view beginning);

/// Removes what was to be published as `path`, begins so, is open in no process, and is not
/// wanted(its name).
void remove_leftovers(
    const std::filesystem::path& path, std::string_view beginning,
    const std::function<bool(const std::string&)>& wanted = [](const std::string&) {
        return false;
    });

}  // namespace nmbcrun
