// SPDX-License-Identifier: MIT
/// CSV files that appear under their names only when they are whole.
#pragma once

#include <filesystem>
#include <nmbc/chain.hpp>
#include <string>

#include "generator/support/posix_file.hpp"

namespace nmbcrun {

class CsvFile {
  public:
    /// Opens a temporary neighbour of `path` and writes the header line (without line end); those
    /// that killed processes have left go.
    /// Throws FileError, here as in every member, where the disk does not take it.
    CsvFile(const std::filesystem::path& path, const std::string& header);

    /// Adds a line (without line end).
    void append(const std::string& line);

    /// All of it is on the disk.
    nmbcgen::NewFile whole();

    /// Gives the whole file its own name.
    void publish();

    const std::filesystem::path& path() const { return path_; }

  private:
    void flush();

    std::filesystem::path path_;
    nmbcgen::FolderOf folder_;
    nmbcgen::PosixFile file_;
    nmbcgen::NewFile made_;
    std::string buffer_;  // not written yet
};

inline constexpr const char* field_header = "node,x,u,v";

/// A CSV file of the interior nodes, a row of field_header each: node 1, 2, .. at x = node dX
/// [length], u at t, v at t - dt/2.
nmbcgen::NewFile write_field(const std::filesystem::path& path, const nmbc::Chain& chain);

}  // namespace nmbcrun
