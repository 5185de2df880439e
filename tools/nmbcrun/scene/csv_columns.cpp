// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/csv_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/scene/regular_file.hpp"
#include "tools/nmbcrun/scene/trimmed.hpp"

namespace nmbcrun {
namespace {

std::vector<std::string_view> entries_of(std::string_view line) {
    std::vector<std::string_view> entries;
    std::size_t begin = 0;
    for (std::size_t comma = line.find(','); comma != std::string_view::npos;
         comma = line.find(',', begin)) {
        entries.push_back(trimmed(line.substr(begin, comma - begin)));
        begin = comma + 1;
    }
    entries.push_back(trimmed(line.substr(begin)));
    return entries;
}

double number_in(std::string_view entry, const std::string& where) {
    double value = 0;
    const auto [end, error] = std::from_chars(entry.data(), entry.data() + entry.size(), value);
    if (error != std::errc() || end != entry.data() + entry.size() || !std::isfinite(value)) {
        throw SceneError(fmt::format("{}: '{}' is not a finite number", where, entry));
    }
    return value;
}

constexpr auto no_place = std::size_t(-1);

/// Where the columns are in a row, the first `required` of which the header has to have; no_place:
/// it has none of this name.
std::vector<std::size_t> places_in(const std::vector<std::string_view>& header,
                                   const std::vector<std::string>& names, std::size_t required,
                                   const std::string& where) {
    std::vector<std::size_t> places;
    places.reserve(names.size());
    for (const std::string& name : names) {
        const auto found = std::ranges::find(header, name);
        if (found == header.end() && places.size() < required) {
            throw SceneError(fmt::format("{}: the header has no column '{}'", where, name));
        }
        places.push_back(found == header.end() ? no_place : std::size_t(found - header.begin()));
    }
    return places;
}

}  // namespace

std::vector<std::vector<double>> read_columns(const std::filesystem::path& path,
                                              const std::vector<std::string>& names,
                                              const std::vector<std::string>& optional) {
    constexpr std::uintmax_t most_bytes = 1U << 30U;  // 10^7 nodes have 0.6e9
    std::ifstream stream = open_regular_file(path, most_bytes);
    return read_columns(stream, path.string(), names, optional);
}

std::vector<std::vector<double>> read_columns(std::istream& stream, const std::string& name,
                                              const std::vector<std::string>& names,
                                              const std::vector<std::string>& optional) {
    std::vector<std::string> all = names;
    all.insert(all.end(), optional.begin(), optional.end());
    std::vector<std::vector<double>> columns(all.size());
    std::vector<std::size_t> places;  // of the columns in a row
    std::size_t header_entries = 0;
    std::string line;
    for (std::size_t number = 1; std::getline(stream, line); ++number) {
        constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
        if (number == 1 && line.starts_with(byte_order_mark)) {
            line.erase(0, byte_order_mark.size());
        }
        if (trimmed(line).empty() || trimmed(line).front() == '#') {
            continue;
        }
        const std::string where = fmt::format("{}:{}", name, number);
        const std::vector<std::string_view> entries = entries_of(line);
        const bool is_header = places.empty();
        header_entries = is_header ? entries.size() : header_entries;
        if (entries.size() > header_entries) {
            throw SceneError(fmt::format("{}: the row has {} entries, the header {}", where,
                                         entries.size(), header_entries));
        }
        if (is_header) {
            places = places_in(entries, all, names.size(), where);
            continue;
        }
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (places[i] == no_place) {
                continue;
            }
            if (places[i] >= entries.size()) {
                throw SceneError(fmt::format("{}: column '{}' is missing", where, all[i]));
            }
            columns[i].push_back(number_in(entries[places[i]], where));
        }
    }
    if (columns.front().empty()) {
        throw SceneError(name + " has no row of numbers");
    }
    return columns;
}

}  // namespace nmbcrun
