// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/run_lock.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <string>

namespace nmbcrun {

RunLock::RunLock(const std::filesystem::path& path)
    : folder_(path), file_(nmbcgen::PosixFile::open_or_create(path)) {
    std::array<char, 256> host{};
    ::gethostname(host.data(), host.size() - 1);
    file_.cut_to(0);
    file_.write(fmt::format("process {} on {}: wait for it, or give another output.name or --out\n",
                            ::getpid(), host.data()));
}

RunLock::~RunLock() {
    std::error_code ignored;
    std::filesystem::remove(file_.path(), ignored);
}

}  // namespace nmbcrun
