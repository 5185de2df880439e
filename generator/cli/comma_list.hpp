// SPDX-License-Identifier: GPL-2.0-or-later
/// Lists on a command line.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace nmbcgen {

/// The items of a list with commas between, a thousand at most. Throws std::invalid_argument, with
/// a message for people, where one is empty or there are more.
inline std::vector<std::string> items_of(const std::string& text) {
    std::vector<std::string> items;
    std::size_t begin = 0;
    std::size_t comma = 0;
    do {
        comma = text.find(',', begin);
        const std::string item = text.substr(begin, comma - begin);
        if (item.empty()) {
            throw std::invalid_argument("'" + text.substr(0, 60) +
                                        "' has an empty item; values go with one comma between");
        }
        constexpr std::size_t most_items = 1000;
        if (items.size() == most_items) {
            throw std::invalid_argument("'" + text.substr(0, 60) + "' has more than " +
                                        std::to_string(most_items) + " items");
        }
        items.push_back(item);
        begin = comma + 1;
    } while (comma != std::string::npos);
    return items;
}

/// What `parse` makes of each item; likewise where a value is there twice.
template <class Value>
std::vector<Value> parse_list(const std::string& text, Value (*parse)(const std::string&)) {
    std::vector<Value> values;
    for (const std::string& item : items_of(text)) {
        const Value value = parse(item);
        if (std::ranges::find(values, value) != values.end()) {
            throw std::invalid_argument("'" + text.substr(0, 60) + "' has the value " + item +
                                        " twice");
        }
        values.push_back(value);
    }
    return values;
}

}  // namespace nmbcgen
