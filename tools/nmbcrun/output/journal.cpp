// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/journal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "generator/names/checksum.hpp"
#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {
namespace {

constexpr std::size_t block = 1 << 16;  // bytes written or read at once

/// Hands the first `size` bytes to `take`, block by block. Returns whether they were all there.
template <class Take>
bool read_blocks(const nmbcgen::PosixFile& file, std::uint64_t size, Take take) {
    std::string bytes(block, '\0');
    for (std::uint64_t done = 0; done < size;) {
        const auto wanted = std::size_t(std::min<std::uint64_t>(block, size - done));
        if (file.read(done, bytes.data(), wanted) != wanted) {
            return false;
        }
        take(std::string_view(bytes).substr(0, wanted));
        done += wanted;
    }
    return true;
}

}  // namespace

Journal::Journal(std::filesystem::path path)
    : path_(std::move(path)),
      file_(nmbcgen::PosixFile::create_beside(path_)),
      mark_{file_.path().filename().string(), 0, nmbcgen::checksum_of_nothing} {}

Journal::Journal(std::filesystem::path path, const Mark& mark)
    : path_(std::move(path)),
      file_(nmbcgen::PosixFile::open(path_.parent_path() / mark.name)),
      mark_(mark),
      is_kept_(true) {
    std::uint64_t found = nmbcgen::checksum_of_nothing;
    const bool whole = read_blocks(
        file_, mark.size, [&](std::string_view bytes) { found = nmbcgen::checksum(bytes, found); });
    if (!whole || found != mark.checksum) {
        throw FileError(fmt::format("cannot go on from {}: it {} since the checkpoint",
                                    file_.path().string(),
                                    whole ? "was changed" : "has become shorter"));
    }
    file_.cut_to(mark.size);
}

Journal::~Journal() {
    if (!is_kept_) {
        std::error_code ignored;
        std::filesystem::remove(file_.path(), ignored);
    }
}

void Journal::append(std::string_view bytes) {
    buffer_ += bytes;
    mark_.size += bytes.size();
    mark_.checksum = nmbcgen::checksum(bytes, mark_.checksum);
    if (buffer_.size() >= block) {
        flush();
    }
}

void Journal::flush() {
    file_.cut_to(mark_.size - buffer_.size());  // a write that failed may have left a part
    file_.write(buffer_);
    buffer_.clear();
}

void Journal::sync() {
    flush();
    file_.sync();
}

const std::filesystem::path& Journal::source() {
    flush();
    return file_.path();
}

nmbcgen::NewFile Journal::copy() {
    flush();
    nmbcgen::PosixFile file = nmbcgen::PosixFile::create_beside(path_);
    nmbcgen::NewFile copy(file.path(), path_);
    if (!read_blocks(file_, mark_.size, [&](std::string_view bytes) { file.write(bytes); })) {
        throw FileError(
            fmt::format("cannot read {}: it has become shorter", file_.path().string()));
    }
    file.sync();
    return copy;
}

}  // namespace nmbcrun
