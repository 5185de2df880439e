// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/csv.hpp"

#include <fmt/format.h>

#include <utility>

#include "tools/nmbcrun/output/leftovers.hpp"

namespace nmbcrun {

CsvFile::CsvFile(const std::filesystem::path& path, const std::string& header)
    : path_(path),
      folder_(path),
      file_(nmbcgen::PosixFile::create_beside(path)),
      made_(file_.path(), path) {
    append(header);
    remove_leftovers(path, buffer_);
    flush();
}

void CsvFile::append(const std::string& line) {
    constexpr std::size_t block = 1 << 16;
    buffer_ += line;
    buffer_ += '\n';
    if (buffer_.size() >= block) {
        flush();
    }
}

void CsvFile::flush() {
    file_.write(buffer_);
    buffer_.clear();
}

nmbcgen::NewFile CsvFile::whole() {
    flush();
    file_.sync();
    return std::move(made_);
}

void CsvFile::publish() {
    nmbcgen::NewFile file = whole();
    nmbcgen::publish({&file, 1});
}

nmbcgen::NewFile write_field(const std::filesystem::path& path, const nmbc::Chain& chain) {
    CsvFile csv(path, field_header);
    const nmbc::ChainParameters& p = chain.parameters();
    for (std::size_t node = 1; node <= p.nodes; ++node) {
        const std::size_t entry = chain.first_interior() + node - 1;
        csv.append(fmt::format("{},{:.10g},{},{}", node, double(node) * p.spacing,
                               chain.displacement()[entry], chain.velocity()[entry]));
    }
    return csv.whole();
}

}  // namespace nmbcrun
