// SPDX-License-Identifier: MIT
/// Files with what streams do not have: names nobody else takes, locks, and being on the disk for
/// sure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

namespace nmbcrun {

/// Every member throws FileError with the path and the system's reason.
class PosixFile {
  public:
    /// A file of a name that was not there, PATH.new-PROCESS, in a folder that is made where it is
    /// missing.
    static PosixFile create_beside(const std::filesystem::path& path);
    /// A file that is there, to be read and written. Nobody else may have it open.
    static PosixFile open(const std::filesystem::path& path);

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

/// The whole file takes the place of another one, and the change of names is on the disk.
void replace(const std::filesystem::path& by, const std::filesystem::path& path);

/// Removes the file unless a process has it open as a PosixFile; nothing where it is not there.
void remove_unless_open(const std::filesystem::path& path);

}  // namespace nmbcrun
