// SPDX-License-Identifier: MIT
/// What the C++ headers of lattices and of conditions have in common.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/table/table.hpp"

namespace nmbcgen {

/// Includes the runtime's table types and the further headers; asserts their schema.
std::string cpp_preamble(const std::string& further_includes);

/// An nmbc::RationalFunction, {"1 2", "3"}.
std::string initialiser(const ExactFunction& function);
std::string initialiser(const Polynomial& polynomial);

/// A constant array and an empty line; line_of(item) is an item's line or lines. Without an item it
/// is nothing: C++ has no such array.
template <class Item, class LineOf>
std::string array(std::string_view type, std::string_view name, const std::vector<Item>& items,
                  LineOf line_of) {
    if (items.empty()) {
        return "";
    }
    std::string text = "inline constexpr " + std::string(type) + " " + std::string(name) + "[]{\n";
    for (const Item& item : items) {
        text += line_of(item);
    }
    return text + "};\n\n";
}

/// The lattice of a table, as nmbc::generated::FAMILY_nH.., in one block that a program may include
/// several times; begins with cpp_preamble().
std::string lattice_source(const Table& table);

}  // namespace nmbcgen
