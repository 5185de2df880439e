// SPDX-License-Identifier: MIT
/// What is wrong with an initial field that reaches an end or side that lets waves out.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace nmbcrun {

/// A warning; empty where it hardly gets there. edge: "left end"; share: the largest value on its
/// outermost nodes, over the largest of all.
inline std::string warning_of_start_at(std::string_view edge, double share) {
    constexpr double negligible = 0.01;
    return share <= negligible
               ? ""
               : fmt::format(
                     "initial reaches the {}, with {:.1g} of its largest value on the outermost "
                     "nodes. What lets waves out knows nothing of what would come in from beyond "
                     "it, so what is found near it is wrong by about as much",
                     edge, share);
}

}  // namespace nmbcrun
