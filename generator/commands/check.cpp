// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <sstream>

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

std::string compare(const std::string& name, const std::string& found, const std::string& fresh) {
    return found == fresh ? "" : fmt::format("differs: {}\n{}", name, changed_lines(found, fresh));
}

}  // namespace

void require_folder(const std::filesystem::path& folder) {
    if (!std::filesystem::is_directory(folder)) {
        throw FileError("cannot read " + folder.string() + ": there is no such folder");
    }
}

std::string staleness(const std::filesystem::path& folder, const std::vector<TextFile>& fresh) {
    std::string report;
    for (const TextFile& file : fresh) {
        const std::string name = file.path.filename().string();
        const auto found = read_file(folder / name);
        report += found ? compare(name, *found, file.text) : "missing: " + name + "\n";
    }
    return report;
}

std::string other_files(const std::filesystem::path& folder, const std::vector<TextFile>& fresh) {
    std::set<std::string> others;  // in order: a folder lists its files in any
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        others.insert(entry->path().filename().string());
    }
    if (error) {
        throw FileError("cannot read " + folder.string() + ": " + error.message());
    }
    for (const TextFile& file : fresh) {
        others.erase(file.path.filename().string());
    }
    return fmt::format("{}", fmt::join(others, ", "));
}

}  // namespace nmbcgen
