// SPDX-License-Identifier: MIT
/// A file of a run that only grows, and from which a stopped run can go on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "generator/support/posix_file.hpp"

namespace nmbcrun {

/// Grows under a temporary name; copies of it are published. Every member throws FileError.
class Journal {
  public:
    /// How far it was written: its name without the folder, its bytes, and a checksum of them.
    struct Mark {
        std::string name;
        std::uint64_t size = 0;
        std::uint64_t checksum = 0;
    };

    /// An empty one that is to be published as `path`.
    explicit Journal(std::filesystem::path path);
    /// One that is there, in the folder of `path`, cut back to the mark. It stays if this throws,
    /// as where it is shorter than the mark or not the same up to there.
    Journal(std::filesystem::path path, const Mark& mark);
    /// Removes the file unless it is kept.
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    void append(std::string_view bytes);

    /// How far it is.
    const Mark& mark() const { return mark_; }
    /// All that was appended is in the file, and on the disk. After a member that threw it may be
    /// tried again.
    void flush();
    void sync();
    /// From here on the file stays when the journal ends, or does not.
    void keep(bool kept) { is_kept_ = kept; }

    /// A copy of it, on the disk, that is to be path().
    nmbcgen::NewFile copy();

    /// Bytes appended so far, and the file that has them all.
    std::uint64_t size() const { return mark_.size; }
    const std::filesystem::path& source();

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    nmbcgen::PosixFile file_;
    std::string buffer_;  // not written yet
    Mark mark_;           // what was appended
    bool is_kept_ = false;
};

}  // namespace nmbcrun
