// SPDX-License-Identifier: MIT
/// Files with what streams do not have: names nobody else takes, locks, and being on the disk for
/// sure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace nmbcgen {

/// A file could not be read or written; what() names it and the system's reason.
struct FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Throws FileError: that one cannot do this with the file, and errno in words.
[[noreturn]] void fail(std::string_view what, const std::filesystem::path& path);

/// The folder of a file, made where it is missing. What of it is made goes with this object where
/// nothing was put there.
class FolderOf {
  public:
    /// Throws FileError.
    explicit FolderOf(const std::filesystem::path& path);
    ~FolderOf();
    FolderOf(const FolderOf&) = delete;
    FolderOf& operator=(const FolderOf&) = delete;
    FolderOf(FolderOf&&) = delete;
    FolderOf& operator=(FolderOf&&) = delete;

  private:
    std::vector<std::filesystem::path> made_;  // the outermost first
};

/// Every member throws FileError with the path and the system's reason.
class PosixFile {
  public:
    /// A file of a name that was not there, PATH.new-PROCESS, in a folder that is made where it is
    /// missing; it may take the place of PATH (require_replaceable).
    static PosixFile create_beside(const std::filesystem::path& path);
    /// A file that is there, to be read and written. Nobody else may have it open.
    static PosixFile open(const std::filesystem::path& path);
    /// The same of a file that may be missing, and its folder, too. Where somebody else has it open
    /// the error has what is in it, as that says who.
    static PosixFile open_or_create(const std::filesystem::path& path);

    PosixFile(PosixFile&& other) noexcept;
    PosixFile& operator=(PosixFile&&) = delete;
    PosixFile(const PosixFile&) = delete;
    PosixFile& operator=(const PosixFile&) = delete;
    /// Closes the file, and leaves it where it is.
    ~PosixFile();

    const std::filesystem::path& path() const { return path_; }
    /// At its end.
    void write(std::string_view bytes);
    /// Fills the buffer with what is there from `offset` on. Returns how much that was, less than
    /// `size` only at the end of the file.
    std::size_t read(std::uint64_t offset, char* buffer, std::size_t size) const;
    void cut_to(std::uint64_t size);
    /// Brings all of it to the disk itself, not only to the system.
    void sync();

  private:
    PosixFile(std::filesystem::path path, int descriptor);
    bool lock() const;

    std::filesystem::path path_;
    int descriptor_;
};

/// A whole file under a temporary name, which goes with this object unless it is published.
class NewFile {
  public:
    /// temporary: the file that is there, in the folder of `path`, its name to be.
    NewFile(std::filesystem::path temporary, std::filesystem::path path);
    NewFile(NewFile&& other) noexcept;
    NewFile& operator=(NewFile&&) = delete;
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;
    ~NewFile();

    const std::filesystem::path& temporary() const { return temporary_; }
    const std::filesystem::path& path() const { return path_; }

  private:
    friend void publish(std::span<NewFile> files);

    std::filesystem::path temporary_;  // none: it has its name
    std::filesystem::path path_;
};

/// Gives files of one folder their names, one right after the other, in the place of what has them;
/// the change is on the disk then. Their bytes must be there (PosixFile::sync). Throws FileError.
void publish(std::span<NewFile> files);

/// Throws FileError where the name is that of a folder or anything else but a regular file.
void require_replaceable(const std::filesystem::path& path);

/// Throws FileError where a file of this name, whose folder may be missing, could not be written
/// (require_replaceable). Leaves nothing.
void require_writable(const std::filesystem::path& path);

/// Removes the file unless a process has it open as a PosixFile; nothing where it is not there.
void remove_unless_open(const std::filesystem::path& path);

}  // namespace nmbcgen
