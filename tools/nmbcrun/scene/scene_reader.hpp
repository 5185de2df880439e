// SPDX-License-Identifier: MIT
/// Reads values out of a TOML document and finds what is wrong with it: a missing or misspelt
/// key, a value of another type, a number out of bounds. Every message says where.
#pragma once

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {

/// Bounds of a number, and the words for them.
struct Bounds {
    double lowest;
    double highest;
    bool lowest_allowed;
    std::string_view words;
};

inline constexpr double largest_number = 1e100;
inline constexpr Bounds positive{0, largest_number, false, "a positive number"};
inline constexpr Bounds not_negative{0, largest_number, true, "a number not below 0"};
inline constexpr Bounds up_to_10{0, 10, true, "a number from 0 to 10"};
inline constexpr Bounds between_0_and_1{0, 1 - 0x1p-53, false,
                                        "a number between 0 and 1, neither of them"};
inline constexpr Bounds any_number{-largest_number, largest_number, true, "a number"};

/// Of the file. Throws FileError where it cannot be read.
std::string read_text(const std::string& path);

class SceneReader {
  public:
    /// Parses the text and puts KEY=VALUE pairs over it. path: of its file, for messages.
    SceneReader(const std::string& text, const std::string& path,
                const std::vector<std::pair<std::string, std::string>>& overrides);

    // Each marks its key (a dotted path such as "model.horizon") as known and returns the value
    // if the key is there.
    std::optional<double> number(std::string_view key, const Bounds& bounds);
    std::optional<long> whole_number(std::string_view key, long lowest, long highest);
    std::optional<std::string> text(std::string_view key);
    /// A string, or the shortest decimal that reads as the number.
    std::optional<std::string> number_or_text(std::string_view key);
    std::optional<bool> truth(std::string_view key);
    /// A list of numbers; empty if the key is not there.
    std::vector<double> numbers(std::string_view key, const Bounds& bounds);
    /// A list [x, y], if the key is there.
    std::optional<std::array<double, 2>> pair(std::string_view key, const Bounds& bounds);
    /// A list of such lists; empty if the key is not there.
    std::vector<std::array<double, 2>> pairs(std::string_view key);
    /// A list of lists [X1, Y1, X2, Y2]; empty if the key is not there.
    std::vector<std::array<double, 4>> segments(std::string_view key);
    /// The names of the tables in a table, which has nothing else; empty if it is not there.
    std::vector<std::string> tables_in(std::string_view key);
    /// A list of strings; empty if the key is not there.
    std::vector<std::string> texts(std::string_view key);
    /// A list whose values are as number_or_text() has them; empty if the key is not there.
    std::vector<std::string> numbers_or_texts(std::string_view key);

    /// Every key of the document that is no table, by its dotted path, and its value as text.
    std::map<std::string, std::string> given() const;

    /// The value, which must be there.
    template <class Value>
    Value required(std::string_view key, const std::optional<Value>& value) const {
        if (!value) {
            missing(key);
        }
        return *value;
    }

    /// Whether the key is there; it is known then.
    bool has(std::string_view key) { return find(key) != nullptr; }
    /// Whether it is there and this string; it is known then.
    bool is_word(std::string_view key, std::string_view word);
    /// Whether it is there and a string.
    bool is_text(std::string_view key) const { return document_.at_path(key).is_string(); }
    /// Whether it is there and a list.
    bool is_list(std::string_view key) const { return document_.at_path(key).is_array(); }

    /// Whether an override set the key.
    bool is_overridden(std::string_view key) const;

    /// Throws for the key if it is there, for the whole file if not.
    [[noreturn]] void fail(std::string_view key, const std::string& problem) const;

    /// Throws for a key that is required: what it may stand for under another name, or the advice.
    [[noreturn]] void missing(std::string_view key, const std::string& advice = "") const;

    /// As fail(), for a key whose value does not fit that of another: of the two an override is
    /// named.
    [[noreturn]] void fail_beside(std::string_view key, std::string_view other,
                                  const std::string& problem) const;

    /// Throws where the document has another key than these outside of all tables: a misspelt table
    /// is named before what is missing without it.
    void refuse_other_tables(const std::vector<std::string>& tables) const;

    /// Throws where the document has a key that none of the calls above asked for.
    void refuse_unknown_keys() const;

  private:
    template <std::size_t Size>
    std::vector<std::array<double, Size>> lists(std::string_view key,
                                                std::string_view allowed_words);
    void apply_override(const std::string& key, const std::string& value);
    void refuse_unknown_keys_in(const toml::table& table, const std::string& prefix) const;
    [[noreturn]] void fail_unknown(const std::string& key,
                                   const std::vector<std::string>& known) const;
    std::string place(std::string_view key) const;
    const toml::node* find(std::string_view key);

    std::string path_;
    toml::table document_;
    std::vector<std::string> known_;
    std::vector<std::string> overridden_;
};

}  // namespace nmbcrun
