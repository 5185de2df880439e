// SPDX-License-Identifier: MIT
// The values of keys: of which type and within which bounds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/names/printable.hpp"
#include "tools/nmbcrun/scene/scene_reader.hpp"
#include "tools/nmbcrun/scene/toml_text.hpp"

namespace nmbcrun {
namespace {

std::string as_written(const toml::node& node) {
    return nmbcgen::beginning_of(text_of(node));
}

bool is_within(double value, const Bounds& bounds) {
    return std::isfinite(value) && value >= bounds.lowest && value <= bounds.highest &&
           (value != bounds.lowest || bounds.lowest_allowed);
}

/// In words, for a value that is not within them.
std::string allowed(const Bounds& bounds, const std::optional<double>& value) {
    const bool too_large = value && std::isfinite(*value) && std::abs(*value) > largest_number;
    return fmt::format("{}{}", bounds.words,
                       too_large ? fmt::format(" of size {:g} at most", largest_number) : "");
}

}  // namespace

std::optional<double> SceneReader::number(std::string_view key, const Bounds& bounds) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    const auto value = node->is_number() ? node->value<double>() : std::nullopt;
    if (!value || !is_within(*value, bounds)) {
        fail(key, fmt::format("must be {}, not {}", allowed(bounds, value), as_written(*node)));
    }
    return value;
}

std::optional<long> SceneReader::whole_number(std::string_view key, long lowest, long highest) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    const auto value = node->is_integer() ? node->value<long>() : std::nullopt;
    const auto decimal = node->is_floating_point() ? node->value<double>() : std::nullopt;
    if (decimal && *decimal >= double(lowest) && *decimal <= double(highest) &&
        std::trunc(*decimal) == *decimal) {
        fail(key,
             fmt::format("must be a whole number from {} to {}, written without a point and an "
                         "exponent: {}",
                         lowest, highest, as_written(*node)));
    }
    if (!value || *value < lowest || *value > highest) {
        fail(key, fmt::format("must be a whole number from {} to {}, not {}", lowest, highest,
                              as_written(*node)));
    }
    return value;
}

std::optional<std::string> SceneReader::text(std::string_view key) {
    const toml::node* node = find(key);
    if (node != nullptr && !node->is_string()) {
        fail(key, fmt::format("must be a string in quotes, not {}", as_written(*node)));
    }
    return node == nullptr ? std::nullopt : node->value<std::string>();
}

std::optional<std::string> SceneReader::number_or_text(std::string_view key) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    if (node->is_string()) {
        return node->value<std::string>();
    }
    if (!node->is_number()) {
        fail(key, fmt::format("must be a number, or one as a string in quotes, not {}",
                              as_written(*node)));
    }
    return text_of(*node);
}

bool SceneReader::is_word(std::string_view key, std::string_view word) {
    return is_text(key) && text(key) == word;
}

std::optional<bool> SceneReader::truth(std::string_view key) {
    const toml::node* node = find(key);
    if (node != nullptr && !node->is_boolean()) {
        fail(key, fmt::format("must be true or false, not {}", as_written(*node)));
    }
    return node == nullptr ? std::nullopt : node->value<bool>();
}

std::vector<double> SceneReader::numbers(std::string_view key, const Bounds& bounds) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return {};
    }
    if (!node->is_array()) {
        fail(key, fmt::format("must be a list of numbers, [1, 2.5], not {}", as_written(*node)));
    }
    std::vector<double> values;
    values.reserve(node->as_array()->size());
    for (const toml::node& entry : *node->as_array()) {
        const auto value = entry.is_number() ? entry.value<double>() : std::nullopt;
        if (!value || !is_within(*value, bounds)) {
            fail(key, fmt::format("must be a list of numbers, each {}; one of them is {}",
                                  allowed(bounds, value), as_written(entry)));
        }
        values.push_back(*value);
    }
    return values;
}

std::optional<std::array<double, 2>> SceneReader::pair(std::string_view key, const Bounds& bounds) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    if (!node->is_array()) {
        fail(key, fmt::format("must be a list [x, y], not {}", as_written(*node)));
    }
    const std::vector<double> values = numbers(key, bounds);
    if (values.size() != 2) {
        fail(key, fmt::format("must be a list [x, y], not one of length {}", values.size()));
    }
    return std::array{values[0], values[1]};
}

template <std::size_t Size>
std::vector<std::array<double, Size>> SceneReader::lists(std::string_view key,
                                                         std::string_view allowed_words) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return {};
    }
    std::vector<std::array<double, Size>> values;
    const auto refuse = [&](const toml::node& entry) {
        fail(key, fmt::format("must be a list of {}, not {}", allowed_words, as_written(entry)));
    };
    if (!node->is_array()) {
        refuse(*node);
    }
    for (const toml::node& entry : *node->as_array()) {
        const toml::array* const list = entry.as_array();
        if (list == nullptr || list->size() != Size) {
            refuse(entry);
        }
        std::array<double, Size>& numbers = values.emplace_back();
        for (std::size_t i = 0; i < Size; ++i) {
            const auto number =
                list->at(i).is_number() ? list->at(i).value<double>() : std::nullopt;
            if (!number) {
                refuse(entry);
            }
            if (!is_within(*number, any_number)) {
                fail(key, fmt::format("has {:g}, which is not {}", *number,
                                      allowed(any_number, number)));
            }
            numbers[i] = *number;
        }
    }
    return values;
}

std::vector<std::array<double, 2>> SceneReader::pairs(std::string_view key) {
    return lists<2>(key, "points, [[1, 2.5], [3, 4]]");
}

std::vector<std::array<double, 4>> SceneReader::segments(std::string_view key) {
    return lists<4>(key, "four numbers each, [[X1, Y1, X2, Y2], ..]");
}

std::vector<std::string> SceneReader::tables_in(std::string_view key) {
    const toml::node* const node = find(key);
    if (node == nullptr) {
        return {};
    }
    std::vector<std::string> names;
    const bool is_of_tables =
        node->is_table() && std::ranges::all_of(*node->as_table(), [](const auto& entry) {
            return entry.second.is_table();
        });
    if (!is_of_tables) {
        fail(key, fmt::format("must be tables with names, such as [{}.top]", key));
    }
    for (const auto& [name, entry] : *node->as_table()) {
        names.emplace_back(name.str());
    }
    return names;
}

std::vector<std::string> SceneReader::texts(std::string_view key) {
    const toml::node* node = find(key);
    const auto is_string = [](const toml::node& each) { return each.is_string(); };
    if (node != nullptr &&
        (!node->is_array() || !std::ranges::all_of(*node->as_array(), is_string))) {
        fail(key, fmt::format(R"(must be a list of strings in quotes, ["a", "b"], not {})",
                              as_written(*node)));
    }
    return numbers_or_texts(key);
}

std::vector<std::string> SceneReader::numbers_or_texts(std::string_view key) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return {};
    }
    if (!node->is_array()) {
        fail(key, fmt::format("must be a list, not {}", as_written(*node)));
    }
    std::vector<std::string> values;
    values.reserve(node->as_array()->size());
    for (const toml::node& entry : *node->as_array()) {
        if (!entry.is_string() && !entry.is_number()) {
            fail(key, fmt::format("must be a list of numbers, or of numbers as strings in quotes; "
                                  "one of them is {}",
                                  as_written(entry)));
        }
        values.push_back(entry.is_string() ? *entry.value<std::string>() : text_of(entry));
    }
    return values;
}

}  // namespace nmbcrun
