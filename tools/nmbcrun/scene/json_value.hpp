// SPDX-License-Identifier: MIT
/// Values of a JSON file, each of which knows where it stands.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace nmbcrun {

/// A view: the document has to outlive it. Its members throw SceneError, with its place and what is
/// allowed there, where it is something else.
class JsonValue {
  public:
    /// path: from the top of the file, such as "tables[3].c[0]".
    JsonValue(const nlohmann::json& value, std::string file, std::string path = {});

    bool is_null() const;
    bool has(const char* key) const;
    /// Of an object that has this key.
    JsonValue at(const char* key) const;
    /// Of a list.
    std::vector<JsonValue> elements() const;
    std::string text() const;
    int whole_number(int lowest, int highest) const;
    double number(double lowest, double highest) const;

    /// "PLACE must be WORDS, not .."
    [[noreturn]] void must_be(std::string_view words) const;

  private:
    std::string place() const;

    const nlohmann::json* value_;
    std::string file_;
    std::string path_;
};

}  // namespace nmbcrun
