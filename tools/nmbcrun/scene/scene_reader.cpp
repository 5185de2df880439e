// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/scene_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <set>

#include "tools/nmbcrun/scene/printable.hpp"
#include "tools/nmbcrun/scene/toml_text.hpp"

namespace nmbcrun {
namespace {

// toml++ leaves nested tables level by level on the stack, of which 8 MiB do for 20 000 levels, and
// a level is two bytes, "a.". No scene is near these lengths: long data are in CSV files.
constexpr std::size_t longest_scene = 32768;
constexpr std::size_t longest_override = 4096;

/// Levenshtein distance.
std::size_t edit_distance(std::string_view left, std::string_view right) {
    std::vector<std::size_t> row(right.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 1; i <= left.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= right.size(); ++j) {
            const std::size_t substituted = diagonal + (left[i - 1] == right[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row.back();
}

std::string as_written(const toml::node& node) {
    return beginning_of(text_of(node));
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

void add_given(const toml::table& table, const std::string& prefix,
               std::map<std::string, std::string>& keys) {
    for (const auto& [name, node] : table) {
        const std::string key = prefix + std::string(name.str());
        if (node.is_table()) {
            add_given(*node.as_table(), key + ".", keys);
        } else {
            keys[key] = text_of(node);
        }
    }
}

}  // namespace

std::string read_text(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream || std::filesystem::is_directory(path)) {  // which a stream opens without a word
        throw FileError(fmt::format("cannot read the scene {}: {}", path,
                                    std::strerror(stream ? EISDIR : errno)));
    }
    // No more than shows that it is too long: some files, such as /dev/zero, never end.
    std::string text(longest_scene + 1, '\0');
    stream.read(text.data(), std::streamsize(text.size()));
    text.resize(std::size_t(stream.gcount()));
    return text;
}

SceneReader::SceneReader(const std::string& text, const std::string& path,
                         const std::vector<std::pair<std::string, std::string>>& overrides)
    : path_(path) {
    if (text.size() > longest_scene) {
        throw SceneError(
            fmt::format("{}: a scene has at most {} bytes; longer data belong in CSV files", path,
                        longest_scene));
    }
    try {
        document_ = toml::parse(text, path);
    } catch (const toml::parse_error& error) {
        throw SceneError(fmt::format("{}:{}: {}", path, error.source().begin.line,
                                     std::string_view(error.description())));
    }
    for (const auto& [key, value] : overrides) {
        apply_override(key, value);
    }
    if (document_.empty()) {
        throw SceneError(path + ": has no keys; docs/reference/scene.md lists those of a scene");
    }
}

void SceneReader::apply_override(const std::string& key, const std::string& value) {
    if (key.size() + value.size() > longest_override) {
        throw SceneError(fmt::format("--set {}..: a key and its value have at most {} bytes",
                                     key.substr(0, 60), longest_override));
    }
    overridden_.push_back(key);
    toml::table* table = &document_;
    std::string_view rest = key;
    for (std::size_t dot = rest.find('.'); dot != std::string_view::npos; dot = rest.find('.')) {
        table->insert(rest.substr(0, dot), toml::table{});
        table = table->get(rest.substr(0, dot))->as_table();
        rest.remove_prefix(dot + 1);
        if (table == nullptr) {
            throw SceneError(
                fmt::format("--set {}: the scene has a value where a table is needed", key));
        }
    }
    // A bare word is a string: --set boundary.ghosts=explicit.
    try {
        const toml::table parsed = toml::parse("value = " + value);
        if (parsed.size() == 1) {
            parsed.get("value")->visit(
                [&](const auto& node) { table->insert_or_assign(rest, node); });
            return;
        }
    } catch (const toml::parse_error&) {
    }
    table->insert_or_assign(rest, value);
}

const toml::node* SceneReader::find(std::string_view key) {
    known_.emplace_back(key);
    return document_.at_path(key).node();
}

bool SceneReader::is_overridden(std::string_view key) const {
    return std::ranges::find(overridden_, key) != overridden_.end();
}

std::string SceneReader::place(std::string_view key) const {
    if (is_overridden(key)) {
        return fmt::format("--set {}", key);
    }
    const auto node = document_.at_path(key);
    if (!node) {
        return fmt::format("{}: {}", path_, key);
    }
    const auto line = node.node()->source().begin.line;
    if (line == 0) {  // a table that no file has, made for an override of something in it
        const auto below = std::ranges::find_if(overridden_, [&](const std::string& other) {
            return other.starts_with(fmt::format("{}.", key));
        });
        return fmt::format("--set {}: {}", below == overridden_.end() ? key : *below, key);
    }
    return fmt::format("{}:{}: {}", path_, line, key);
}

void SceneReader::fail(std::string_view key, const std::string& problem) const {
    throw SceneError(fmt::format("{} {}", place(key), problem));
}

void SceneReader::missing(std::string_view key) const {
    const std::string_view group = key.substr(0, key.find('.'));
    if (document_.contains(group) && !document_.get(group)->is_table()) {
        fail(group, "must be a table");
    }
    const auto given = this->given();
    const auto meant = std::ranges::find_if(given, [&](const auto& one) {
        return std::ranges::find(known_, one.first) == known_.end() &&
               3 * edit_distance(one.first, std::string(key)) <= key.size();
    });
    throw SceneError(fmt::format(
        "{}: {} is missing{}", path_, key,
        meant == given.end() ? "" : fmt::format("; is {} meant for it?", meant->first)));
}

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
    if (decimal && std::isfinite(*decimal) && std::trunc(*decimal) == *decimal) {
        fail(key,
             fmt::format("must be a whole number from {} to {}, written without a point and an "
                         "exponent",
                         lowest, highest));
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
    const std::vector<double> values = numbers(key, bounds);
    if (find(key) == nullptr) {
        return std::nullopt;
    }
    if (values.size() != 2) {
        fail(key, fmt::format("must be a list [x, y], not one of {} numbers", values.size()));
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
            if (!number || !is_within(*number, any_number)) {
                refuse(entry);
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

std::map<std::string, std::string> SceneReader::given() const {
    std::map<std::string, std::string> keys;
    add_given(document_, "", keys);
    return keys;
}

void SceneReader::fail_unknown(const std::string& key,
                               const std::vector<std::string>& known) const {
    const auto distance = [&](const std::string& other) {
        return other.ends_with("." + key) ? 0 : edit_distance(key, other);
    };
    std::set<std::string> names(known.begin(), known.end());
    for (const std::string& name : known) {  // the groups of them, too
        for (auto dot = name.find('.'); dot != std::string::npos; dot = name.find('.', dot + 1)) {
            names.insert(name.substr(0, dot));
        }
    }
    const auto nearest = std::ranges::min_element(names, {}, distance);
    // One that shares less than half its letters is no help; those of a common table do not count.
    const auto same = std::ranges::mismatch(key, *nearest).in1 - key.begin();
    const auto dot = key.rfind('.', std::size_t(same));
    const std::size_t own = dot == std::string::npos ? key.size() : key.size() - dot - 1;
    const bool near = 2 * distance(*nearest) <= own;
    fail(key,
         "is not a key of a scene" + (near ? "; the nearest one is " + *nearest
                                           : std::string("; docs/reference/scene.md lists them")));
}

void SceneReader::refuse_other_tables(const std::vector<std::string>& tables) const {
    for (const auto& [name, node] : document_) {
        const std::string key(name.str());
        if (key.find('.') == std::string::npos &&  // which refuse_unknown_keys() explains
            std::ranges::find(tables, key) == tables.end()) {
            fail_unknown(key, tables);
        }
    }
}

void SceneReader::refuse_unknown_keys() const {
    refuse_unknown_keys_in(document_, "");
}

void SceneReader::refuse_unknown_keys_in(const toml::table& table,
                                         const std::string& prefix) const {
    for (const auto& [name, node] : table) {
        const std::string key = prefix + std::string(name.str());
        if (name.str().find('.') != std::string_view::npos) {
            fail(key, "is one quoted name; a dot between two names goes without quotes");
        }
        const bool is_group = std::ranges::any_of(
            known_, [&](const std::string& known) { return known.starts_with(key + "."); });
        if (is_group && node.is_table()) {
            refuse_unknown_keys_in(*node.as_table(), key + ".");
        } else if (is_group) {
            fail(key, "must be a table");
        } else if (std::ranges::find(known_, key) == known_.end()) {
            fail_unknown(key, known_);
        }
    }
}

}  // namespace nmbcrun
