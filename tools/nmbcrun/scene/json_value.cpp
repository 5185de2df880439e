// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/json_value.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "generator/names/printable.hpp"
#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {
namespace {

/// The beginning of it, where it is long.
std::string as_written(const nlohmann::json& value) {
    if (value.is_structured()) {
        return value.is_object() ? "an object" : fmt::format("a list of {}", value.size());
    }
    return nmbcgen::beginning_of(value.dump());
}

}  // namespace

JsonValue::JsonValue(const nlohmann::json& value, std::string file, std::string path)
    : value_(&value), file_(std::move(file)), path_(std::move(path)) {}

std::string JsonValue::place() const {
    return path_.empty() ? file_ : file_ + ": " + path_;
}

bool JsonValue::is_null() const {
    return value_->is_null();
}

bool JsonValue::has(const char* key) const {
    return value_->contains(key);
}

JsonValue JsonValue::at(const char* key) const {
    if (!value_->is_object()) {
        must_be("an object");
    }
    const auto found = value_->find(key);
    if (found == value_->end()) {
        throw SceneError(fmt::format("{} has no key \"{}\"", place(), key));
    }
    return {*found, file_, path_.empty() ? key : path_ + "." + key};
}

std::vector<JsonValue> JsonValue::elements() const {
    if (!value_->is_array()) {
        must_be("a list");
    }
    std::vector<JsonValue> list;
    list.reserve(value_->size());
    for (const nlohmann::json& element : *value_) {
        list.emplace_back(element, file_, fmt::format("{}[{}]", path_, list.size()));
    }
    return list;
}

std::string JsonValue::text() const {
    if (!value_->is_string()) {
        must_be("a string");
    }
    return value_->get<std::string>();
}

int JsonValue::whole_number(int lowest, int highest) const {
    // Whole numbers beyond 64 bits are floating ones to the parser.
    const bool is_within =
        value_->is_number_integer() &&
        (value_->is_number_unsigned() ? value_->get<unsigned long long>() <= unsigned(highest)
                                      : value_->get<long long>() <= highest) &&
        value_->get<long long>() >= lowest;
    if (!is_within) {
        must_be(lowest == highest ? fmt::format("{}", lowest)
                                  : fmt::format("a whole number from {} to {}", lowest, highest));
    }
    return value_->get<int>();
}

double JsonValue::number(double lowest, double highest) const {
    if (!value_->is_number() || !(value_->get<double>() >= lowest) ||
        !(value_->get<double>() <= highest)) {
        must_be(fmt::format("a number from {} to {}", lowest, highest));
    }
    return value_->get<double>();
}

void JsonValue::must_be(std::string_view words) const {
    throw SceneError(fmt::format("{} must be {}, not {}", place(), words, as_written(*value_)));
}

}  // namespace nmbcrun
