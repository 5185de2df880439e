// SPDX-License-Identifier: MIT
/// What is open in the HDF5 library.
#pragma once

#include <hdf5.h>

#include <utility>

namespace nmbcrun {

/// To be called before the first file: what fails is reported by results alone.
inline void silence_hdf5() {
    // After a write that failed the library crashes in what it does at the end of the program
    // (h5py, issue 914); everything is closed here.
    H5dont_atexit();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

/// Closes an identifier that is one.
class Hdf5Handle {
  public:
    Hdf5Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    ~Hdf5Handle() {
        if (id_ >= 0) {
            close_(id_);
        }
    }
    Hdf5Handle(Hdf5Handle&& other) noexcept
        : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
    Hdf5Handle& operator=(Hdf5Handle&&) = delete;
    Hdf5Handle(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(const Hdf5Handle&) = delete;
    hid_t operator*() const { return id_; }

  private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

}  // namespace nmbcrun
