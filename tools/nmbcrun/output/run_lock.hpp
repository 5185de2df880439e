// SPDX-License-Identifier: MIT
/// One run of a name in a folder at a time.
#pragma once

#include <filesystem>

#include "generator/support/posix_file.hpp"

namespace nmbcrun {

/// The file FOLDER/NAME.lock, which says who has it. It is there as long as this object; of a run
/// that was killed the file stays, and is nobody's.
class RunLock {
  public:
    /// Makes the folder where it is missing; it goes with the lock where nothing was put there.
    /// Throws FileError where another run has the lock.
    explicit RunLock(const std::filesystem::path& path);
    ~RunLock();
    RunLock(const RunLock&) = delete;
    RunLock& operator=(const RunLock&) = delete;

  private:
    nmbcgen::FolderOf folder_;
    nmbcgen::PosixFile file_;
};

}  // namespace nmbcrun
