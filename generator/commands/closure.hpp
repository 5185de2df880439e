// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen closure: true ends of chains.
#pragma once

#include <string>
#include <vector>

#include "generator/table/exact.hpp"

namespace nmbcgen {

struct ClosureTask {
    std::string method;  ///< "snm" or "sbp"
    unsigned horizon = 0;
    bool corrected = false;           ///< of snm: beta_1 = 3/2
    std::vector<Rational> weights{};  ///< of sbp: w_1 .. w_n
};

/// The rows of a closure: for people, or JSON (docs/reference/json-other.md). Throws as the
/// closures do.
std::string closure_text(const ClosureTask& task);
std::string closure_json(const ClosureTask& task);

}  // namespace nmbcgen
