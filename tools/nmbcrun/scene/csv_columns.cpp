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

}  // namespace

std::vector<std::vector<double>> read_columns(const std::filesystem::path& path,
                                              const std::vector<std::string>& names) {
    constexpr std::uintmax_t most_bytes = 1U << 30U;  // 10^7 nodes have 0.6e9
    std::ifstream stream = open_regular_file(path, most_bytes);
    return read_columns(stream, path.string(), names);
}

std::vector<std::vector<double>> read_columns(std::istream& stream, const std::string& name,
                                              const std::vector<std::string>& names) {
    std::vector<std::vector<double>> columns(names.size());
    std::vector<std::size_t> places;
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
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (is_header) {
                const auto found = std::ranges::find(entries, names[i]);
                if (found == entries.end()) {
                    throw SceneError(
                        fmt::format("{}: the header has no column '{}'", where, names[i]));
                }
                places.push_back(std::size_t(found - entries.begin()));
            } else if (places[i] >= entries.size()) {
                throw SceneError(fmt::format("{}: column '{}' is missing", where, names[i]));
            } else {
                columns[i].push_back(number_in(entries[places[i]], where));
            }
        }
    }
    if (columns.front().empty()) {
        throw SceneError(name + " has no row of numbers");
    }
    return columns;
}

}  // namespace nmbcrun
