// SPDX-License-Identifier: MIT
#include "generator/support/posix_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

namespace nmbcgen {

void fail(std::string_view what, const std::filesystem::path& path) {
    const int reason = errno;
    throw FileError(fmt::format("cannot {} {}: {}", what, path.string(), std::strerror(reason)));
}

PosixFile::PosixFile(std::filesystem::path path, int descriptor)
    : path_(std::move(path)), descriptor_(descriptor) {}

PosixFile::PosixFile(PosixFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

PosixFile::~PosixFile() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
}

namespace {

constexpr mode_t for_all = 0666;  // less the user's umask, as every other file

/// What is in the folder of `path` is on the disk then, as far as the file system can do that.
void sync_folder_of(const std::filesystem::path& path) {
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        ::fsync(descriptor);
        ::close(descriptor);
    }
}

/// Adds those that it has made, the outer ones first.
void make_folder(const std::filesystem::path& folder, std::vector<std::filesystem::path>& made) {
    if (folder.empty() || std::filesystem::is_directory(folder)) {
        return;
    }
    make_folder(folder.parent_path(), made);
    if (std::filesystem::create_directory(folder)) {
        made.push_back(folder);
    }
    sync_folder_of(folder);
}

void remove_empty(std::vector<std::filesystem::path>& made) {
    std::error_code ignored;  // of those that are not empty
    for (; !made.empty(); made.pop_back()) {
        std::filesystem::remove(made.back(), ignored);
    }
}

/// A FolderOf may remove a folder between two looks at it: what fails for that is tried again, so
/// often at most.
constexpr int most_tries = 100;

/// Gives those that it has made.
std::vector<std::filesystem::path> make_folder_of(const std::filesystem::path& path) {
    for (int tries = 1;; ++tries) {
        std::vector<std::filesystem::path> made;
        try {
            make_folder(path.parent_path(), made);
            return made;
        } catch (const std::filesystem::filesystem_error& error) {
            remove_empty(made);
            const bool is_gone_meanwhile = error.code() == std::errc::no_such_file_or_directory ||
                                           error.code() == std::errc::file_exists;
            if (!is_gone_meanwhile || tries == most_tries) {
                throw FileError(fmt::format("cannot make the folder {}: {}",
                                            path.parent_path().string(), error.code().message()));
            }
        }
    }
}

}  // namespace

FolderOf::FolderOf(const std::filesystem::path& path) : made_(make_folder_of(path)) {}

FolderOf::~FolderOf() {
    remove_empty(made_);
}

PosixFile PosixFile::create_beside(const std::filesystem::path& path) {
    require_replaceable(path);
    make_folder_of(path);
    int tries = 1;
    for (int number = 0;;) {  // a process of the same number may have left one
        auto name = std::filesystem::path(path).concat(
            fmt::format(".new-{}{}", ::getpid(), number == 0 ? "" : fmt::format("-{}", number)));
        const int descriptor =
            ::open(name.c_str(), O_RDWR | O_APPEND | O_CREAT | O_EXCL | O_CLOEXEC, for_all);
        if (descriptor >= 0) {
            PosixFile file(std::move(name), descriptor);
            file.lock();
            return file;
        }
        if (errno == ENOENT && path.has_parent_path() && tries++ < most_tries) {
            make_folder_of(path);
        } else if (errno == EEXIST) {
            ++number;
        } else {
            fail("write", path);
        }
    }
}

PosixFile PosixFile::open(const std::filesystem::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_APPEND | O_CLOEXEC);
    if (descriptor < 0) {
        fail("open", path);
    }
    PosixFile file(path, descriptor);
    if (!file.lock()) {
        throw FileError(
            fmt::format("cannot open {}: a run that goes on has it open", path.string()));
    }
    return file;
}

PosixFile PosixFile::open_or_create(const std::filesystem::path& path) {
    require_replaceable(path);
    for (int tries = 1;; ++tries) {
        make_folder_of(path);
        const int descriptor =
            ::open(path.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC, for_all);
        if (descriptor < 0 && errno == ENOENT && path.has_parent_path() && tries < most_tries) {
            continue;
        }
        if (descriptor < 0) {
            fail("write", path);
        }
        PosixFile file(path, descriptor);
        if (!file.lock()) {
            std::string who(200, '\0');
            who.resize(file.read(0, who.data(), who.size()));
            throw FileError(fmt::format("cannot open {}: it is held by {}", path.string(),
                                        who.substr(0, who.find('\n'))));
        }
        struct stat opened {};
        struct stat named {};
        if (::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
            opened.st_ino == named.st_ino && opened.st_dev == named.st_dev) {
            return file;
        }  // else who had it has removed it meanwhile
    }
}

/// Whether nobody else has it; true, too, where the file system knows no locks.
bool PosixFile::lock() const {
    return ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

void PosixFile::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) {
            fail("write", path_);
        }
        bytes.remove_prefix(std::size_t(std::max<ssize_t>(written, 0)));
    }
}

std::size_t PosixFile::read(std::uint64_t offset, char* buffer, std::size_t size) const {
    std::size_t done = 0;
    while (done < size) {
        const ssize_t got = ::pread(descriptor_, buffer + done, size - done, off_t(offset + done));
        if (got == 0) {
            break;
        }
        if (got < 0 && errno != EINTR) {
            fail("read", path_);
        }
        done += std::size_t(std::max<ssize_t>(got, 0));
    }
    return done;
}

void PosixFile::cut_to(std::uint64_t size) {
    if (::ftruncate(descriptor_, off_t(size)) != 0) {
        fail("write", path_);
    }
}

void PosixFile::sync() {
    if (::fsync(descriptor_) != 0) {
        fail("write", path_);
    }
}

NewFile::NewFile(std::filesystem::path temporary, std::filesystem::path path)
    : temporary_(std::move(temporary)), path_(std::move(path)) {}

NewFile::NewFile(NewFile&& other) noexcept
    : temporary_(std::exchange(other.temporary_, {})), path_(std::move(other.path_)) {}

NewFile::~NewFile() {
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
}

void publish(std::span<NewFile> files) {
    for (NewFile& file : files) {
        if (::rename(file.temporary_.c_str(), file.path_.c_str()) != 0) {
            fail("write", file.path_);
        }
        file.temporary_.clear();
    }
    if (files.empty()) {
        return;
    }
    sync_folder_of(files.front().path_);
}

void require_replaceable(const std::filesystem::path& path) {
    std::error_code ignored;  // what is not there, or not to be seen, is in nobody's way
    const auto status = std::filesystem::status(path, ignored);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
        throw FileError(
            fmt::format("cannot write {}: {} of that name is in the way", path.string(),
                        std::filesystem::is_directory(status) ? "a folder" : "a special file"));
    }
}

void require_writable(const std::filesystem::path& path) {
    const FolderOf folder(path);
    const NewFile trial(PosixFile::create_beside(path).path(), path);
}

void remove_unless_open(const std::filesystem::path& path) {
    try {
        const PosixFile file = PosixFile::open(path);
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
    } catch (const FileError&) {  // not there, somebody else's, or open
    }
}

}  // namespace nmbcgen
