// SPDX-License-Identifier: MIT
#include "generator/support/files.hpp"

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <system_error>

namespace nmbcgen {

void write_files(const std::vector<TextFile>& files) {
    std::vector<NewFile> changed;
    for (const TextFile& file : files) {
        require_replaceable(file.path);
        if (read_file(file.path) == file.text) {
            continue;  // what is built from it stays up to date
        }
        PosixFile written = PosixFile::create_beside(file.path);
        changed.emplace_back(written.path(), file.path);
        written.write(file.text);
        written.sync();
    }
    publish(changed);
}

std::optional<std::string> read_file(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        if (error) {
            errno = error.value();
            fail("read", path);
        }
        return std::nullopt;
    }
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    if (stream.peek() != std::ifstream::traits_type::eof()) {  // << calls an empty file a failure
        text << stream.rdbuf();
    }
    if (!stream.is_open() || stream.bad() || !text) {
        fail("read", path);
    }
    return text.str();
}

void print(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() ||
        std::fflush(stdout) != 0) {
        fail("write", "standard output");
    }
}

}  // namespace nmbcgen
