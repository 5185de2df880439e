// SPDX-License-Identifier: MIT
/// Certificates kept from one run to the next: nmbcgen --cache.
#pragma once

#include <filesystem>
#include <vector>

#include "generator/table/table.hpp"

namespace nmbcgen {

/// A folder with one file a table. A file counts only where the table it was made for and the
/// source code that made it are what they are now; others are ignored, and written anew.
class CertificateCache {
  public:
    explicit CertificateCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Gives the table its certificate, where that is known.
    void look_up(Table& table) const;

    /// Throws FileError where the folder cannot be written to.
    void keep(const std::vector<Table>& tables) const;

  private:
    std::filesystem::path folder_;
};

}  // namespace nmbcgen
