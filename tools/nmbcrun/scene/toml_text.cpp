// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/toml_text.hpp"

#include <fmt/format.h>

#include <sstream>

namespace nmbcrun {

std::string text_of(const toml::node& node, int levels) {
    if (levels == 0) {
        return "..";
    }
    if (const toml::array* list = node.as_array()) {
        std::string text;
        for (const toml::node& element : *list) {
            text += (text.empty() ? "" : ", ") + text_of(element, levels - 1);
        }
        return "[" + text + "]";
    }
    if (const toml::table* table = node.as_table()) {
        std::string text;
        for (const auto& [name, element] : *table) {
            text += (text.empty() ? "" : ", ") + std::string(name.str()) + " = " +
                    text_of(element, levels - 1);
        }
        return "{" + text + "}";
    }
    // 1 and 1.0 are the same number, but not every whole number is a double.
    if (const auto number = node.value<double>(); number && node.is_number()) {
        return fmt::format("{}", *number);
    }
    std::ostringstream stream;
    node.visit([&stream](const auto& value) { stream << value; });
    return stream.str();
}

}  // namespace nmbcrun
