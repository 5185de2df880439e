// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/warnings.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "generator/names/printable.hpp"

namespace nmbcrun {

void print_warnings(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) {
        fmt::print(stderr, "nmbcrun: warning: {}\n", nmbcgen::printable(warning));
    }
}

}  // namespace nmbcrun
