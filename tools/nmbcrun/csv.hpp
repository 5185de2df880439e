// SPDX-License-Identifier: MIT
/// A CSV file that appears under its name only when it is whole.
#pragma once

#include <filesystem>
#include <fstream>
#include <nmbc/energy.hpp>

namespace nmbcrun {

class EnergyCsv {
  public:
    /// Opens a temporary neighbour of `path` and writes the header line.
    /// Throws FileError, here as in every member, where the disk does not take it.
    explicit EnergyCsv(std::filesystem::path path);
    /// Removes the temporary file unless publish() was called.
    ~EnergyCsv();
    EnergyCsv(const EnergyCsv&) = delete;
    EnergyCsv& operator=(const EnergyCsv&) = delete;

    void append(double time, const nmbc::Energies& energies);

    /// Gives the file its own name.
    void publish();

    const std::filesystem::path& path() const { return path_; }

  private:
    [[noreturn]] void fail() const;

    std::filesystem::path path_;
    std::filesystem::path temporary_;
    std::ofstream stream_;
};

}  // namespace nmbcrun
