// SPDX-License-Identifier: MIT
/// Keys that name one of a few things.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/nmbcrun/scene/scene_reader.hpp"

namespace nmbcrun {

/// The value of a key that names one of these, if it is there.
template <class Value>
std::optional<Value> read_choice(SceneReader& reader, const std::string& key,
                                 const std::vector<std::pair<std::string_view, Value>>& choices) {
    const auto given = reader.text(key);
    if (!given) {
        return std::nullopt;
    }
    std::string allowed;
    for (const auto& [name, value] : choices) {
        if (*given == name) {
            return value;
        }
        const char* separator = name == choices.back().first ? " or " : ", ";
        allowed += fmt::format("{}\"{}\"", allowed.empty() ? "" : separator, name);
    }
    reader.fail(key, "must be " + allowed + ", not \"" + *given + '"');
}

}  // namespace nmbcrun
