// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/regular_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {

std::ifstream open_regular_file(const std::filesystem::path& path, std::uintmax_t most_bytes) {
    const auto refuse = [&](const std::string& why) {
        return FileError(fmt::format("cannot read {}: {}", path.string(), why));
    };
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        throw refuse(error ? error.message() : std::strerror(ENOENT));
    }
    // Before it is opened: that alone waits for ever at a pipe that nobody writes into.
    if (!std::filesystem::is_regular_file(status)) {
        throw refuse(std::filesystem::is_directory(status) ? std::strerror(EISDIR)
                                                           : "it is not a regular file");
    }
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (!error && size > most_bytes) {
        throw SceneError(fmt::format("{} has {} bytes; at most {} are allowed", path.string(), size,
                                     most_bytes));
    }
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        throw refuse(std::strerror(errno));
    }
    return stream;
}

}  // namespace nmbcrun
