// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/table_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "generator/table/schema.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/scene/json_value.hpp"
#include "tools/nmbcrun/scene/regular_file.hpp"
#include "tools/nmbcrun/scene/table_reader.hpp"

namespace nmbcrun {
namespace {

std::string contents_of(const std::filesystem::path& path) {
    std::ifstream stream = open_regular_file(path, TableFile::most_bytes);
    std::string text(TableFile::most_bytes + 1, '\0');
    stream.read(text.data(), std::streamsize(text.size()));
    text.resize(std::size_t(stream.gcount()));
    text.shrink_to_fit();
    if (stream.bad()) {
        throw FileError(fmt::format("cannot read {}", path.string()));
    }
    return text;
}

nlohmann::json parsed(const std::string& text, const std::string& name) {
    constexpr int deepest = 12;  // of a table: 8
    const auto look = [&](int depth, nlohmann::json::parse_event_t /*event*/,
                          const nlohmann::json& /*value*/) {
        if (depth > deepest) {
            throw SceneError(
                fmt::format("{} is no table of nmbcgen: it is nested too deeply", name));
        }
        return true;
    };
    try {
        return nlohmann::json::parse(text, look);
    } catch (const nlohmann::json::exception& error) {
        const std::string_view what = error.what();
        const std::size_t number = what.find("] ");  // after the exception's own name
        throw SceneError(
            fmt::format("{} is no JSON: {}", name,
                        number == std::string_view::npos ? what : what.substr(number + 2)));
    }
}

}  // namespace

TableFile::TableFile(const std::filesystem::path& path)
    : TableFile(contents_of(path), path.string()) {}

TableFile::TableFile(std::string text, std::string name)
    : name_(std::move(name)), text_(std::move(text)) {
    const nlohmann::json document = parsed(text_, name_);
    const JsonValue top(document, name_);
    top.at("schema").whole_number(nmbcgen::json_schema, nmbcgen::json_schema);
    if (!top.has("tables")) {
        tables_.push_back(read_table(top, read_lattice(top.at("lattice"), storage_), storage_));
        return;
    }
    std::map<std::string_view, OwnLattice> lattices;
    for (const JsonValue& each : top.at("lattices").elements()) {
        const OwnLattice lattice = read_lattice(each, storage_);
        lattices.insert({lattice.table->name, lattice});
    }
    for (const JsonValue& each : top.at("tables").elements()) {
        const auto found = lattices.find(each.at("lattice").text());
        if (found == lattices.end()) {
            each.at("lattice").must_be("the name of one of the lattices");
        }
        tables_.push_back(read_table(each, found->second, storage_));
    }
}

}  // namespace nmbcrun
