// SPDX-License-Identifier: MIT
/// What users may not expect of their runs.
#pragma once

#include <string>
#include <vector>

namespace nmbcrun {

/// On stderr, a line each.
void print_warnings(const std::vector<std::string>& warnings);

}  // namespace nmbcrun
