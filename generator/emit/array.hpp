// SPDX-License-Identifier: MIT
/// Arrays of a C++ table.
#pragma once

#include <string>
#include <vector>

namespace nmbcgen {

/// A constant array and an empty line; line_of(item) is an item's line or lines. Without an item it
/// is nothing: C++ has no such array.
template <class Item, class LineOf>
std::string array(const std::string& type, const std::string& name, const std::vector<Item>& items,
                  LineOf line_of) {
    if (items.empty()) {
        return "";
    }
    std::string text = "inline constexpr " + type + " " + name + "[]{\n";
    for (const Item& item : items) {
        text += line_of(item);
    }
    return text + "};\n\n";
}

}  // namespace nmbcgen
