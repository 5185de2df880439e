// SPDX-License-Identifier: MIT
/// Numbers from the HDF5 files that a scene names.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/nmbcrun/scene/hdf5_handle.hpp"

namespace nmbcrun {

/// A dataset of numbers, open.
class Hdf5Dataset {
  public:
    const std::string& name() const { return name_; }
    /// Its rows, columns, ..
    const std::vector<std::size_t>& extents() const { return extents_; }

    /// So many rows, one after another. Throws SceneError where one of the numbers is not finite,
    /// FileError where they cannot be read.
    std::vector<double> rows(std::size_t first, std::size_t count) const;

  private:
    friend class Hdf5Input;
    Hdf5Dataset(std::filesystem::path path, std::string name, Hdf5Handle dataset);

    std::filesystem::path path_;
    std::string name_;
    Hdf5Handle dataset_;
    std::vector<std::size_t> extents_{};
};

class Hdf5Input {
  public:
    /// Throws FileError where the file cannot be read, SceneError where it is none of HDF5.
    explicit Hdf5Input(const std::filesystem::path& path);

    bool has(const std::string& name) const;

    /// Throws SceneError where there is no dataset of this name, or it does not hold numbers.
    Hdf5Dataset dataset(const std::string& name) const;

    /// The number in a text that is attached to the file, if there is one.
    std::optional<double> attached_number(const std::string& name) const;

  private:
    std::filesystem::path path_;
    Hdf5Handle file_;
};

/// The datasets of these names, in this order, which are lists of as many numbers each. Throws as
/// Hdf5Input does, and SceneError where they are no such lists or have more than 10^8 numbers.
std::vector<std::vector<double>> read_datasets(const std::filesystem::path& path,
                                               const std::vector<std::string>& names);

}  // namespace nmbcrun
