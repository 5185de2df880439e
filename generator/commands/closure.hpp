// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen closure: true ends of chains.
#pragma once

#include <string>

namespace nmbcgen {

struct ClosureTask {
    std::string method;
    unsigned horizon = 0;
    bool corrected = false;  ///< beta_1 = 3/2
};

/// The surface node method's rows: for people, or JSON (docs/reference/json.md).
std::string surface_node_text(const ClosureTask& task);
std::string surface_node_json(const ClosureTask& task);

}  // namespace nmbcgen
