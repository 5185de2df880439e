// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/csv.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {

CsvFile::CsvFile(std::filesystem::path path, const std::string& header)
    : path_(std::move(path)),
      temporary_(std::filesystem::path(path_).concat(fmt::format(".new-{}", ::getpid()))) {
    std::error_code error;
    std::filesystem::create_directories(path_.parent_path(), error);
    if (error) {
        throw FileError(fmt::format("cannot make the folder {}: {}", path_.parent_path().string(),
                                    error.message()));
    }
    stream_.open(temporary_);
    stream_ << header << "\n";
    if (!stream_.flush()) {
        fail();
    }
}

CsvFile::~CsvFile() {
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
}

void CsvFile::append(const std::string& line) {
    stream_ << line << "\n";
    if (!stream_) {
        fail();
    }
}

void CsvFile::publish() {
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

void CsvFile::fail() const {
    const int reason = errno;
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);  // a constructor that throws has no destructor
    throw FileError(fmt::format("cannot write {}: {}", path_.string(), std::strerror(reason)));
}

void append_field(CsvFile& csv, const nmbc::Chain& chain) {
    const nmbc::ChainParameters& p = chain.parameters();
    for (std::size_t node = 1; node <= p.nodes; ++node) {
        const std::size_t entry = chain.first_interior() + node - 1;
        csv.append(fmt::format("{},{:.10g},{},{}", node, double(node) * p.spacing,
                               chain.displacement()[entry], chain.velocity()[entry]));
    }
}

}  // namespace nmbcrun
