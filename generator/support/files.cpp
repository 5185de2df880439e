// SPDX-License-Identifier: MIT
#include "generator/support/files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

namespace nmbcgen {
namespace {

[[noreturn]] void fail(const std::string& action, const std::filesystem::path& path, int error) {
    throw FileError("cannot " + action + " " + path.string() + ": " + std::strerror(error));
}

/// Writes `text` to `path`, on behalf of `target`, and flushes it to disk: a full disk shows at
/// the latest when the data are forced out.
void write_through(const std::filesystem::path& path, const std::string& text,
                   const std::filesystem::path& target) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) {
        fail("write", target, errno);
    }
    std::size_t written = 0;
    while (written < text.size()) {
        const ssize_t count = ::write(file, text.data() + written, text.size() - written);
        if (count < 0 && errno != EINTR) {
            const int error = errno;
            ::close(file);
            fail("write", target, error);
        }
        written += count > 0 ? std::size_t(count) : 0;
    }
    const bool synchronised = ::fsync(file) == 0;
    const int error = errno;
    if (::close(file) != 0 || !synchronised) {
        fail("write", target, synchronised ? errno : error);
    }
}

}  // namespace

void write_files(const std::vector<TextFile>& files) {
    const std::string suffix = ".new-" + std::to_string(::getpid());
    const auto temporary = [&suffix](const TextFile& file) {
        return std::filesystem::path(file.path).concat(suffix);
    };
    const auto clean_up = [&] {
        for (const TextFile& file : files) {
            std::error_code ignored;
            std::filesystem::remove(temporary(file), ignored);
        }
    };
    try {
        for (const TextFile& file : files) {
            std::filesystem::create_directories(file.path.parent_path());
            if (std::filesystem::is_directory(file.path)) {
                fail("write", file.path, EISDIR);  // renaming would find out only half-way
            }
            if (read_file(file.path) == file.text) {
                continue;  // unchanged: what is built from it stays up to date
            }
            write_through(temporary(file), file.text, file.path);
        }
        for (const TextFile& file : files) {
            if (std::filesystem::exists(temporary(file))) {
                std::filesystem::rename(temporary(file), file.path);
            }
        }
    } catch (const std::filesystem::filesystem_error& error) {
        clean_up();
        fail("write", error.path1(), error.code().value());
    } catch (...) {
        clean_up();
        throw;
    }
}

std::optional<std::string> read_file(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        if (error) {
            fail("read", path, error.value());
        }
        return std::nullopt;
    }
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    if (stream.peek() != std::ifstream::traits_type::eof()) {  // << calls an empty file a failure
        text << stream.rdbuf();
    }
    if (!stream.is_open() || stream.bad() || !text) {
        fail("read", path, errno);
    }
    return text.str();
}

void print(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() ||
        std::fflush(stdout) != 0) {
        fail("write", "standard output", errno);
    }
}

}  // namespace nmbcgen
