// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/hdf5_input.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/scene/any_scene.hpp"
#include "tools/nmbcrun/scene/regular_file.hpp"

namespace nmbcrun {
namespace {

FileError unreadable(const std::filesystem::path& path, const std::string& why) {
    return FileError(fmt::format("cannot read {}: {}", path.string(), why));
}

hid_t opened(const std::filesystem::path& path) {
    silence_hdf5();
    open_regular_file(path, std::numeric_limits<std::uintmax_t>::max());
    if (H5Fis_hdf5(path.c_str()) <= 0) {
        throw SceneError(path.string() + " is no HDF5 file");
    }
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file < 0) {
        throw unreadable(path, "the file is damaged, or a program is writing it");
    }
    return file;
}

std::string refused(const std::filesystem::path& path, const std::string& name,
                    const std::string& why) {
    return fmt::format("{}: '{}' {}", path.string(), name, why);
}

/// Where the place of a number in a dataset is: row, column, ..
std::vector<std::size_t> place_of(std::size_t number, std::vector<std::size_t> extents) {
    for (std::size_t axis = extents.size(); axis-- > 0;) {
        const std::size_t at = number % extents[axis];
        number /= extents[axis];
        extents[axis] = at;
    }
    return extents;
}

}  // namespace

Hdf5Input::Hdf5Input(const std::filesystem::path& path)
    : path_(path), file_(opened(path), H5Fclose) {}

bool Hdf5Input::has(const std::string& name) const {
    return H5Lexists(*file_, name.c_str(), H5P_DEFAULT) > 0;
}

Hdf5Dataset Hdf5Input::dataset(const std::string& name) const {
    if (!has(name)) {
        throw SceneError(fmt::format("{} has no dataset '{}'", path_.string(), name));
    }
    Hdf5Handle object(H5Oopen(*file_, name.c_str(), H5P_DEFAULT), H5Oclose);
    if (*object < 0) {
        throw unreadable(path_, fmt::format("what '{}' links to is not there", name));
    }
    if (H5Iget_type(*object) != H5I_DATASET) {
        throw SceneError(
            refused(path_, name, "is a group of datasets, where one dataset is needed"));
    }
    const Hdf5Handle type(H5Dget_type(*object), H5Tclose);
    const H5T_class_t kind = H5Tget_class(*type);
    if (kind != H5T_FLOAT && kind != H5T_INTEGER) {
        throw SceneError(refused(path_, name, "does not hold numbers"));
    }
    return {path_, name, std::move(object)};
}

Hdf5Dataset::Hdf5Dataset(std::filesystem::path path, std::string name, Hdf5Handle dataset)
    : path_(std::move(path)), name_(std::move(name)), dataset_(std::move(dataset)) {
    const Hdf5Handle space(H5Dget_space(*dataset_), H5Sclose);
    std::vector<hsize_t> extents(std::size_t(std::max(0, H5Sget_simple_extent_ndims(*space))));
    H5Sget_simple_extent_dims(*space, extents.data(), nullptr);
    extents_.assign(extents.begin(), extents.end());
}

std::vector<double> Hdf5Dataset::rows(std::size_t first, std::size_t count) const {
    std::vector<std::size_t> extents = extents_;
    std::vector<hsize_t> begin(extents.size());
    begin[0] = first;
    extents[0] = count;
    const std::vector<hsize_t> sizes(extents.begin(), extents.end());
    std::vector<double> values(
        std::accumulate(extents.begin(), extents.end(), std::size_t(1), std::multiplies()));
    const Hdf5Handle space(H5Dget_space(*dataset_), H5Sclose);
    const Hdf5Handle memory(H5Screate_simple(int(sizes.size()), sizes.data(), nullptr), H5Sclose);
    if (H5Sselect_hyperslab(*space, H5S_SELECT_SET, begin.data(), nullptr, sizes.data(), nullptr) <
            0 ||
        H5Dread(*dataset_, H5T_NATIVE_DOUBLE, *memory, *space, H5P_DEFAULT, values.data()) < 0) {
        throw unreadable(path_, fmt::format("'{}' is damaged", name_));
    }
    const auto wrong =
        std::ranges::find_if(values, [](double value) { return !std::isfinite(value); });
    if (wrong != values.end()) {
        std::vector<std::size_t> place = place_of(std::size_t(wrong - values.begin()), extents);
        place[0] += first;
        throw SceneError(fmt::format("{}: '{}'[{}] is {}, which is not finite", path_.string(),
                                     name_, fmt::join(place, ", "), *wrong));
    }
    return values;
}

std::optional<double> Hdf5Input::attached_number(const std::string& name) const {
    if (H5Aexists(*file_, name.c_str()) <= 0) {
        return std::nullopt;
    }
    const Hdf5Handle attribute(H5Aopen(*file_, name.c_str(), H5P_DEFAULT), H5Aclose);
    const Hdf5Handle type(H5Aget_type(*attribute), H5Tclose);
    constexpr std::size_t most = 64;
    std::string text(most, '\0');
    if (H5Tget_class(*type) != H5T_STRING) {
        return std::nullopt;
    }
    if (H5Tis_variable_str(*type) > 0) {  // as h5py copies it
        char* found = nullptr;
        if (H5Aread(*attribute, *type, &found) >= 0 && found != nullptr) {
            text = found;
            H5free_memory(found);
        }
    } else if (H5Tget_size(*type) <= most) {
        H5Aread(*attribute, *type, text.data());
    }
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() ? std::optional(number) : std::nullopt;
}

std::vector<std::vector<double>> read_datasets(const std::filesystem::path& path,
                                               const std::vector<std::string>& names) {
    const Hdf5Input file(path);
    std::vector<std::vector<double>> columns;
    std::size_t size = 0;
    for (const std::string& name : names) {
        const Hdf5Dataset dataset = file.dataset(name);
        const std::vector<std::size_t>& extents = dataset.extents();
        if (extents.size() != 1 || extents[0] == 0 || extents[0] > std::size_t(most_nodes) ||
            (!columns.empty() && extents[0] != size)) {
            throw SceneError(fmt::format(
                "{}: '{}' has the size [{}], and must be a list of 1 to {} numbers, as many as "
                "'{}'",
                path.string(), name, fmt::join(extents, ", "), most_nodes, names.front()));
        }
        size = extents[0];
        columns.push_back(dataset.rows(0, size));
    }
    return columns;
}

}  // namespace nmbcrun
