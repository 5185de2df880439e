// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/csv.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {

EnergyCsv::EnergyCsv(std::filesystem::path path)
    : path_(std::move(path)),
      temporary_(std::filesystem::path(path_).concat(fmt::format(".new-{}", ::getpid()))) {
    std::error_code error;
    std::filesystem::create_directories(path_.parent_path(), error);
    if (error) {
        throw FileError(fmt::format("cannot make the folder {}: {}", path_.parent_path().string(),
                                    error.message()));
    }
    stream_.open(temporary_);
    stream_ << "time,kinetic,strain,stabilisation,total,staggered,damped\n";
    if (!stream_.flush()) {
        fail();
    }
}

EnergyCsv::~EnergyCsv() {
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
}

void EnergyCsv::append(double time, const nmbc::Energies& energies) {
    // The time is a rounded multiple of the step, which ten digits hide; the energies read back.
    stream_ << fmt::format("{:.10g},{},{},{},{},{},{}\n", time, energies.kinetic, energies.strain,
                           energies.stabilisation, energies.total(), energies.staggered,
                           energies.damped);
    if (!stream_) {
        fail();
    }
}

void EnergyCsv::publish() {
    stream_.close();
    std::error_code error;
    if (!stream_) {
        fail();
    }
    std::filesystem::rename(temporary_, path_, error);
    if (error) {
        throw FileError(fmt::format("cannot write {}: {}", path_.string(), error.message()));
    }
}

void EnergyCsv::fail() const {
    const int reason = errno;
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);  // a constructor that throws has no destructor
    throw FileError(fmt::format("cannot write {}: {}", path_.string(), std::strerror(reason)));
}

}  // namespace nmbcrun
