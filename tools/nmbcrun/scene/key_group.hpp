// SPDX-License-Identifier: MIT
/// The keys of one table of a scene.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/nmbcrun/scene/read_choice.hpp"
#include "tools/nmbcrun/scene/sources.hpp"

namespace nmbcrun {

class KeyGroup {
  public:
    KeyGroup(SceneReader& reader, std::string name, const std::string& path)
        : reader_(reader),
          name_(std::move(name)),
          folder_(std::filesystem::path(path).parent_path()) {}

    SceneReader& reader() const { return reader_; }
    std::string key(std::string_view key) const { return name_ + "." + std::string(key); }

    double number(std::string_view name, const Bounds& bounds) const {
        return reader_.required(key(name), reader_.number(key(name), bounds));
    }
    double number_or(std::string_view name, const Bounds& bounds, double otherwise) const {
        return reader_.number(key(name), bounds).value_or(otherwise);
    }
    /// Neither 0 nor so small that energies, which are of its square, are.
    double not_zero(std::string_view name) const {
        const double value = number(name, any_number);
        constexpr double smallest = 1e-100;
        if (value == 0) {
            reader_.fail(key(name), "must not be 0");
        }
        if (std::abs(value) < smallest) {
            reader_.fail(key(name), fmt::format("must be of size {:g} at least, not {:g}: energies "
                                                "are of its square, too small for doubles",
                                                smallest, value));
        }
        return value;
    }
    template <class Value>
    Value choice(std::string_view name,
                 const std::vector<std::pair<std::string_view, Value>>& choices) const {
        return reader_.required(key(name), read_choice(reader_, key(name), choices));
    }
    /// That of the file, where `name` says "csv" or "hdf5".
    FileFormat format_in(std::string_view name) const {
        return reader_.is_word(key(name), "hdf5") ? FileFormat::hdf5 : FileFormat::csv;
    }
    std::filesystem::path file() const {
        return folder_ / reader_.required(key("file"), reader_.text(key("file")));
    }

    /// These are keys of the table, but not beside the choice that `because` names.
    void refuse(std::initializer_list<std::string_view> keys, std::string_view because) const {
        for (const std::string_view each : keys) {
            if (reader_.has(key(each))) {
                reader_.fail(key(each), "has no meaning for " + std::string(because));
            }
        }
    }

  private:
    SceneReader& reader_;
    std::string name_;
    std::filesystem::path folder_;
};

}  // namespace nmbcrun
