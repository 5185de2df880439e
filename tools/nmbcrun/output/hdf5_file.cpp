// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/hdf5_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {

Hdf5File::Hdf5File(const std::filesystem::path& path)
    : made_(nmbcgen::PosixFile::create_beside(path).path(), path) {
    silence_hdf5();
    file_ = checked(H5Fcreate(made_.temporary().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
}

Hdf5File::~Hdf5File() {
    for (const auto& [name, dataset] : datasets_) {
        H5Dclose(dataset);
    }
    if (file_ >= 0) {
        H5Fclose(file_);
    }
}

hid_t Hdf5File::checked(hid_t result) const {
    if (result < 0) {
        const int reason = errno;  // HDF5 passes it on from where it failed, as a rule
        throw FileError(fmt::format("cannot write {}: {}", made_.path().string(),
                                    reason == 0 ? "HDF5 refuses" : std::strerror(reason)));
    }
    return result;
}

void Hdf5File::attach(hid_t object, const Attributes& attributes) const {
    for (const auto& [name, text] : attributes) {
        const Hdf5Handle type(checked(H5Tcopy(H5T_C_S1)), H5Tclose);
        checked(H5Tset_size(*type, text.size() + 1));
        const Hdf5Handle space(checked(H5Screate(H5S_SCALAR)), H5Sclose);
        const Hdf5Handle attribute(
            checked(H5Acreate2(object, name.c_str(), *type, *space, H5P_DEFAULT, H5P_DEFAULT)),
            H5Aclose);
        checked(H5Awrite(*attribute, *type, text.c_str()));
    }
}

void Hdf5File::describe(const Attributes& attributes) {
    attach(file_, attributes);
}

void Hdf5File::add(const std::string& name, const std::vector<std::size_t>& extents,
                   const Attributes& attributes) {
    const std::vector<hsize_t> sizes(extents.begin(), extents.end());
    const Hdf5Handle space(checked(H5Screate_simple(int(sizes.size()), sizes.data(), nullptr)),
                           H5Sclose);
    const Hdf5Handle properties(checked(H5Pcreate(H5P_DATASET_CREATE)), H5Pclose);
    checked(H5Pset_obj_track_times(*properties, false));  // no dates: the same run, the same file
    checked(H5Pset_fill_time(*properties, H5D_FILL_TIME_NEVER));
    const hid_t dataset = checked(H5Dcreate2(file_, name.c_str(), H5T_IEEE_F64LE, *space,
                                             H5P_DEFAULT, *properties, H5P_DEFAULT));
    datasets_[name] = dataset;
    attach(dataset, attributes);
}

void Hdf5File::link(const std::string& name, const std::string& file, const std::string& dataset) {
    const Hdf5Handle properties(checked(H5Pcreate(H5P_LINK_CREATE)), H5Pclose);
    checked(H5Pset_create_intermediate_group(*properties, 1));
    checked(H5Lcreate_external(file.c_str(), dataset.c_str(), file_, name.c_str(), *properties,
                               H5P_DEFAULT));
}

void Hdf5File::write(const std::string& name, std::size_t row, std::span<const double> values) {
    const hid_t dataset = datasets_.at(name);
    const Hdf5Handle space(checked(H5Dget_space(dataset)), H5Sclose);
    const std::vector<hsize_t> start{row, 0};
    const std::vector<hsize_t> count{1, values.size()};
    checked(
        H5Sselect_hyperslab(*space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr));
    const hsize_t size = values.size();
    const Hdf5Handle memory(checked(H5Screate_simple(1, &size, nullptr)), H5Sclose);
    checked(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, *memory, *space, H5P_DEFAULT, values.data()));
}

void Hdf5File::write(const std::string& name, std::span<const double> values) {
    checked(H5Dwrite(datasets_.at(name), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                     values.data()));
}

nmbcgen::NewFile Hdf5File::whole() {
    for (const auto& [name, dataset] : datasets_) {
        checked(H5Dclose(dataset));
    }
    datasets_.clear();
    checked(H5Fclose(std::exchange(file_, H5I_INVALID_HID)));
    nmbcgen::PosixFile::open(made_.temporary()).sync();
    return std::move(made_);
}

}  // namespace nmbcrun
