// SPDX-License-Identifier: MIT
/// CSV files that appear under their names only when they are whole.
#pragma once

#include <filesystem>
#include <fstream>
#include <nmbc/chain.hpp>
#include <string>

namespace nmbcrun {

class CsvFile {
  public:
    /// Opens a temporary neighbour of `path` and writes the header line (without line end).
    /// Throws FileError, here as in every member, where the disk does not take it.
    CsvFile(std::filesystem::path path, const std::string& header);
    /// Removes the temporary file unless publish() was called.
    ~CsvFile();
    CsvFile(const CsvFile&) = delete;
    CsvFile& operator=(const CsvFile&) = delete;

    /// Adds a line (without line end).
    void append(const std::string& line);

    /// Gives the file its own name.
    void publish();

    const std::filesystem::path& path() const { return path_; }

  private:
    [[noreturn]] void fail() const;

    std::filesystem::path path_;
    std::filesystem::path temporary_;
    std::ofstream stream_;
};

inline constexpr const char* field_header = "node,x,u,v";

/// The interior nodes, a row of field_header each: node 1, 2, .. at x = node dX [length], u at t, v
/// at t - dt/2.
void append_field(CsvFile& csv, const nmbc::Chain& chain);

}  // namespace nmbcrun
