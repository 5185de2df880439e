// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/scene_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <set>

#include "tools/nmbcrun/scene/toml_text.hpp"
#include "tools/nmbcrun/scene/trimmed.hpp"

namespace nmbcrun {
namespace {

// toml++ leaves nested tables level by level on the stack, of which 8 MiB do for 20 000 levels, and
// a level is two bytes, "a.". No scene is near these lengths: long data are in CSV files.
constexpr std::size_t longest_scene = 32768;
constexpr std::size_t longest_override = 4096;

/// Levenshtein distance, where two neighbours that changed places count once.
std::size_t edit_distance(std::string_view left, std::string_view right) {
    std::vector<std::size_t> row(right.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    std::vector<std::size_t> above(row.size());
    std::vector<std::size_t> two_above(row.size());
    for (std::size_t i = 1; i <= left.size(); ++i) {
        two_above = std::exchange(above, row);
        row[0] = i;
        for (std::size_t j = 1; j <= right.size(); ++j) {
            const bool is_same = left[i - 1] == right[j - 1];
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (is_same ? 0 : 1)});
            if (i > 1 && j > 1 && left[i - 1] == right[j - 2] && left[i - 2] == right[j - 1]) {
                row[j] = std::min(row[j], two_above[j - 2] + 1);
            }
        }
    }
    return row.back();
}

/// "model." of "model.nu"
std::string_view table_of(std::string_view key) {
    return key.substr(0, key.rfind('.') + 1);
}

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& letter : result) {
        letter = letter >= 'A' && letter <= 'Z' ? char(letter - 'A' + 'a') : letter;
    }
    return result;
}

/// Whether a misspelt key is one that is missing: of one table, with less than half of its letters
/// changed, capitals or not.
bool may_be_meant(std::string_view given, std::string_view missing) {
    const std::string_view table = table_of(missing);
    const std::string_view name = missing.substr(table.size());
    return table_of(given) == table &&
           2 * edit_distance(lower(given.substr(table.size())), lower(name)) < name.size();
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

/// A word in or before the column of a fault that seems to be a string without its quotes, such as
/// nmbc in `kind = nmbc`; empty where there is none.
std::string_view unquoted(std::string_view text, const toml::source_position& fault) {
    for (auto line = fault.line; line > 1; --line) {
        const std::size_t end = text.find('\n');
        text = end == std::string_view::npos ? "" : text.substr(end + 1);
    }
    text = text.substr(0, text.find('\n'));
    const std::size_t before = text.find_last_of("=,[{", fault.column - 1);
    const std::size_t key = text.find('=');
    if (before == std::string_view::npos || key > before || trimmed(text.substr(0, key)).empty()) {
        return {};
    }
    text.remove_prefix(before + 1);
    const std::string_view word = trimmed(text.substr(0, text.find_first_of(",]}#")));
    std::string lower_case;
    for (const char c : word) {
        lower_case += char(std::tolower(static_cast<unsigned char>(c)));
    }
    const bool is_plain = lower_case.find_first_not_of(
                              "abcdefghijklmnopqrstuvwxyz0123456789_-./ ") == std::string::npos;
    constexpr std::array others{"true", "false", "inf", "nan"};
    const bool is_word = is_plain && (lower_case.find_first_of("abcdefghijklmnopqrstuvwxyz") == 0 ||
                                      word.starts_with("./") || word.starts_with("../"));
    return is_word && std::ranges::find(others, lower_case) == others.end() ? word
                                                                            : std::string_view();
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
        const toml::source_position& fault = error.source().begin;
        const std::string_view word = unquoted(text, fault);
        throw SceneError(
            fmt::format("{}:{}: {}{}", path, fault.line, std::string_view(error.description()),
                        word.empty() ? "" : fmt::format("; a string needs quotes: \"{}\"", word)));
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
    std::vector<std::string> below;
    for (const std::string& other : overridden_) {
        if (key.starts_with(other + ".")) {
            return fmt::format("--set {}: {}", other, key);
        }
        if (other.starts_with(fmt::format("{}.", key))) {
            below.push_back("--set " + other);
        }
    }
    const auto node = document_.at_path(key);
    if (!node) {
        return fmt::format("{}: {}", path_, key);
    }
    const auto line = node.node()->source().begin.line;
    if (line == 0 && !below.empty()) {  // a table that no file has, made for them
        return fmt::format("{}: {}", below.front(), key);
    }
    return fmt::format("{}:{}: {}{}", path_, line, key,
                       below.empty() ? "" : fmt::format(", with {},", fmt::join(below, ", ")));
}

void SceneReader::fail(std::string_view key, const std::string& problem) const {
    throw SceneError(fmt::format("{} {}", place(key), problem));
}

void SceneReader::fail_beside(std::string_view key, std::string_view other,
                              const std::string& problem) const {
    if (!is_overridden(key) && is_overridden(other)) {
        throw SceneError(fmt::format("--set {}: {} {}", other, key, problem));
    }
    fail(key, problem);
}

void SceneReader::missing(std::string_view key, const std::string& advice) const {
    const std::string_view group = key.substr(0, key.find('.'));
    if (document_.contains(group) && !document_.get(group)->is_table()) {
        fail(group, "must be a table");
    }
    const auto whole = std::ranges::find_if(
        overridden_, [&](const std::string& other) { return key.starts_with(other + "."); });
    const auto given = this->given();
    const auto meant = std::ranges::find_if(given, [&](const auto& one) {
        return std::ranges::find(known_, one.first) == known_.end() && may_be_meant(one.first, key);
    });
    std::string hint = advice.empty() ? "" : ": " + advice;
    if (meant != given.end()) {
        hint = fmt::format("; is {} meant for it?", meant->first);
    }
    throw SceneError(fmt::format(
        "{}: {} is missing{}", whole == overridden_.end() ? path_ : "--set " + *whole, key, hint));
}

std::map<std::string, std::string> SceneReader::given() const {
    std::map<std::string, std::string> keys;
    add_given(document_, "", keys);
    return keys;
}

void SceneReader::fail_unknown(const std::string& key,
                               const std::vector<std::string>& known) const {
    const auto distance = [&](const std::string& other) {
        const bool is_alike = std::ranges::equal(key, other, [](unsigned char a, unsigned char b) {
            return std::tolower(a) == std::tolower(b);
        });
        return is_alike || other.ends_with("." + key) ? 0 : edit_distance(key, other);
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
                                           : std::string("; docs/reference/scene.md lists "
                                                         "them, plane-scene.md those of planes")));
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
