// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "generator/emit/emit.hpp"
#include "generator/exact/rational.hpp"
#include "generator/pipeline.hpp"

namespace nmbcgen {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

/// The lines between the common beginning and the common end, old ones with -, new ones with +;
/// at most eight of each.
std::string changed_lines(const std::string& before, const std::string& after) {
    const auto old_lines = lines_of(before);
    const auto new_lines = lines_of(after);
    const std::size_t shorter = std::min(old_lines.size(), new_lines.size());
    std::size_t head = 0;
    while (head < shorter && old_lines[head] == new_lines[head]) {
        ++head;
    }
    std::size_t tail = 0;
    while (tail < shorter - head && *(old_lines.rbegin() + std::ptrdiff_t(tail)) ==
                                        *(new_lines.rbegin() + std::ptrdiff_t(tail))) {
        ++tail;
    }
    constexpr std::size_t shown = 8;
    std::string diff = fmt::format("  @@ line {} @@\n", head + 1);
    const auto append = [&](const std::vector<std::string>& lines, char sign) {
        const std::size_t end = lines.size() - tail;
        for (std::size_t i = head; i < std::min(end, head + shown); ++i) {
            diff += fmt::format("  {}{}\n", sign, lines[i]);
        }
        if (end > head + shown) {
            diff += fmt::format("  {}... and {} more lines\n", sign, end - head - shown);
        }
    };
    append(old_lines, '-');
    append(new_lines, '+');
    return diff;
}

/// The text that belongs into a file with this name, where it is the name of a table.
std::optional<std::string> text_by_name(const std::string& file_name) {
    static const std::regex pattern(
        R"((\w+?)_n(\d{1,4})_order(\d{1,4})(?:_s(\d{1,4}))?(?:_G(\d+)o(\d+))?\.(hpp|json))");
    std::smatch match;
    if (!std::regex_match(file_name, match, pattern)) {
        return std::nullopt;
    }
    Specification what{.family = match[1],
                       .horizon = unsigned(std::stoul(match[2])),
                       .order = unsigned(std::stoul(match[3])),
                       .stride = match[4].matched ? unsigned(std::stoul(match[4])) : 1,
                       .stabilisation = {}};
    try {
        if (match[5].matched) {
            what.stabilisation = parse_rational(match[5].str() + "/" + match[6].str());
        }
        const Table table = derive(what);
        return match[7] == "hpp" ? emit_header(table) : emit_json(table);
    } catch (const std::exception&) {
        return std::nullopt;  // no table by this name exists
    }
}

std::string compare(const std::string& name, const std::string& found, const std::string& fresh) {
    return found == fresh ? "" : fmt::format("differs: {}\n{}", name, changed_lines(found, fresh));
}

}  // namespace

std::string staleness(const std::filesystem::path& folder, const std::vector<TextFile>& fresh) {
    std::string report;
    std::set<std::string> expected;
    for (const TextFile& file : fresh) {
        const std::string name = file.path.filename().string();
        expected.insert(name);
        const auto found = read_file(folder / name);
        report += found ? compare(name, *found, file.text) : "missing: " + name + "\n";
    }

    std::error_code error;
    std::set<std::string> others;  // in order: a folder lists its files in any
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string();
        if (!expected.contains(name)) {
            others.insert(name);
        }
    }
    for (const std::string& name : others) {
        const auto text = text_by_name(name);
        report += text ? compare(name, read_file(folder / name).value_or(""), *text)
                       : "left over: " + name + " (no table has this name: delete it)\n";
    }
    return report;
}

}  // namespace nmbcgen
