// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/read_exact.hpp"

#include <stdexcept>

#include "generator/exact/rational.hpp"

namespace nmbcrun {

std::optional<std::string> read_exact(SceneReader& reader, const std::string& key) {
    const auto given = reader.number_or_text(key);
    try {
        return given ? std::optional(nmbcgen::to_string(nmbcgen::parse_rational(*given)))
                     : std::nullopt;
    } catch (const std::invalid_argument& error) {
        reader.fail(key, "must be an exact number not below 0: " + std::string(error.what()));
    }
}

}  // namespace nmbcrun
