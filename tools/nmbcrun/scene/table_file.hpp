// SPDX-License-Identifier: MIT
/// Tables that users make for their scenes with nmbcgen --format json (docs/reference/json.md).
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <nmbc/table.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/nmbcrun/scene/exact_json.hpp"

namespace nmbcrun {

/// A table, and what the runtime's has no place for.
struct OwnTable {
    nmbc::MatchingTable table;
    bool is_certified = false;  ///< not: written with --uncertified, without windows
};

/// What the views of tables see. Each element stays where it is.
struct TableStorage {
    std::deque<std::string> texts;
    std::deque<std::vector<nmbc::RationalFunction>> functions;
    std::deque<std::vector<nmbc::EnergySquare>> squares;
    std::deque<std::vector<nmbc::Window>> windows;
    std::deque<std::vector<nmbc::StableStep>> steps;
    std::deque<nmbc::LatticeTable> lattices;

    std::string_view keep(std::string text) { return texts.emplace_back(std::move(text)); }
    nmbc::RationalFunction keep(Fraction function) {
        return {keep(std::move(function.numerator)), keep(std::move(function.denominator))};
    }
};

/// The tables of one file, of whose strings it is the owner.
class TableFile {
  public:
    /// Files have at most so many bytes: the whole committed set has 0.4 million.
    static constexpr std::uintmax_t most_bytes = 16'000'000;

    /// Throws FileError where there is no such regular file or it cannot be read, SceneError as
    /// below and where it is too long.
    explicit TableFile(const std::filesystem::path& path);

    /// Of a text: one table, or {"schema", "lattices": [..], "tables": [..]}. name: of its file,
    /// for messages. Throws SceneError, with key and what is allowed, where it is no such JSON, a
    /// list has another length than order, horizon or stencil say, a number is not written as
    /// docs/reference/json.md has it, or the symbol is not that of the energy.
    TableFile(std::string text, std::string name);

    // The tables point into it.
    TableFile(const TableFile&) = delete;
    TableFile& operator=(const TableFile&) = delete;

    const std::string& name() const { return name_; }
    const std::string& text() const { return text_; }
    const std::vector<OwnTable>& tables() const { return tables_; }

  private:
    std::string name_;
    std::string text_;
    TableStorage storage_;
    std::vector<OwnTable> tables_;
};

}  // namespace nmbcrun
