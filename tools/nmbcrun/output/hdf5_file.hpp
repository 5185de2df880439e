// SPDX-License-Identifier: MIT
/// An HDF5 file of datasets of doubles.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "generator/support/posix_file.hpp"
#include "tools/nmbcrun/scene/hdf5_handle.hpp"

namespace nmbcrun {

/// Has a temporary name until it is published. The same calls make the same file, byte by byte.
/// Every member throws FileError.
class Hdf5File {
  public:
    using Attributes = std::vector<std::pair<std::string, std::string>>;

    explicit Hdf5File(const std::filesystem::path& path);
    /// Removes the file unless it is whole.
    ~Hdf5File();
    Hdf5File(const Hdf5File&) = delete;
    Hdf5File& operator=(const Hdf5File&) = delete;

    /// Of the file as a whole.
    void describe(const Attributes& attributes);

    /// A dataset of so many rows, columns, ..
    void add(const std::string& name, const std::vector<std::size_t>& extents,
             const Attributes& attributes);

    /// Makes a name, "GROUP/NAME", of a dataset in another file; relative to this one's folder.
    void link(const std::string& name, const std::string& file, const std::string& dataset);

    /// Writes one row, or one value of a dataset of one extent.
    void write(const std::string& name, std::size_t row, std::span<const double> values);

    /// Writes a whole dataset, row by row.
    void write(const std::string& name, std::span<const double> values);

    /// Closes it; all of it is on the disk.
    nmbcgen::NewFile whole();

  private:
    hid_t checked(hid_t result) const;
    void attach(hid_t object, const Attributes& attributes) const;

    nmbcgen::NewFile made_;
    hid_t file_ = H5I_INVALID_HID;
    std::map<std::string, hid_t> datasets_;
};

}  // namespace nmbcrun
