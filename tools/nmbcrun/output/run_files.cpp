// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/run_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/energies_file.hpp"
#include "tools/nmbcrun/output/leftovers.hpp"

namespace nmbcrun {
namespace {

/// The energies of a run that goes on.
constexpr std::string_view growing = ".csv.part";

}  // namespace

RunFiles::RunFiles(Set set, std::string_view about, std::vector<Journal::Mark> marks)
    : set_(std::move(set)), marks_(std::move(marks)) {
    require_free_names();
    open("energies", ".csv", energies_head(about, set_.energies_header));
}

RunFiles::~RunFiles() {
    std::error_code ignored;
    std::filesystem::remove(path(growing), ignored);
}

std::filesystem::path RunFiles::path(std::string_view ending) const {
    return set_.folder / (set_.name + std::string(ending));
}

/// Of all files, whatever the scene asks for: those it does not are removed at the end.
void RunFiles::require_free_names() const {
    std::vector<std::string_view> endings{".csv"};
    std::ranges::transform(set_.others, std::back_inserter(endings), &Kind::ending);
    for (const std::string_view ending : endings) {
        nmbcgen::require_replaceable(path(ending));
        require_not_read(path(ending));
    }
    for (const std::filesystem::path& name : set_.further) {
        require_not_read(name);
    }
}

/// A file, or what is in a folder.
void RunFiles::require_not_read(const std::filesystem::path& name) const {
    for (const std::filesystem::path& input : set_.inputs) {
        std::error_code none;  // of them is there
        if (std::filesystem::equivalent(input, name, none) ||
            std::filesystem::equivalent(input.parent_path(), name, none)) {
            throw SceneError(
                fmt::format("the scene reads {}, which this run would replace or remove; "
                            "another output.name or --out is needed",
                            input.string()));
        }
    }
}

Journal& RunFiles::open(std::string label, std::string_view ending, std::string_view beginning) {
    std::unique_ptr<Journal> journal;
    if (marks_.empty()) {
        journal = std::make_unique<Journal>(path(ending));
        journal->append(beginning);
    } else if (journals_.size() < marks_.size()) {
        journal = std::make_unique<Journal>(path(ending), marks_[journals_.size()]);
    } else {
        throw FileError("the checkpoint has fewer files than its scene");
    }
    journals_.push_back({std::move(label), std::move(journal)});
    return *journals_.back().journal;
}

void RunFiles::begin() {
    if (!marks_.empty() && journals_.size() != marks_.size()) {
        throw FileError("the checkpoint has more files than its scene");
    }
    for (const auto& [label, journal] : journals_) {
        journal->source();  // what cannot be written is known before the first step
    }
    // Where the file system knows no links there is none.
    std::error_code ignored;
    std::filesystem::remove(path(growing), ignored);
    std::filesystem::create_symlink(energies_journal().source().filename(), path(growing), ignored);
}

std::string RunFiles::own_ending() const {
    const Journal& energies = *journals_.front().journal;
    return energies.mark().name.substr(energies.path().filename().string().size());
}

std::vector<Journal::Mark> RunFiles::marks() const {
    std::vector<Journal::Mark> marks;
    for (const auto& [label, journal] : journals_) {
        marks.push_back(journal->mark());
    }
    return marks;
}

void RunFiles::sync() {
    for (const auto& [label, journal] : journals_) {
        journal->sync();
    }
}

void RunFiles::keep(bool kept) {
    for (const auto& [label, journal] : journals_) {
        journal->keep(kept);
    }
}

std::vector<nmbcgen::NewFile> RunFiles::copies() {
    std::vector<nmbcgen::NewFile> files;
    for (const auto& [label, journal] : journals_) {
        files.push_back(journal->copy());
    }
    return files;
}

void RunFiles::publish(std::vector<nmbcgen::NewFile> files) const {
    for (const auto& [ending, beginning] : set_.others) {
        const std::filesystem::path other = path(ending);
        const bool is_new = std::ranges::find(files, other, &nmbcgen::NewFile::path) != files.end();
        std::error_code error;
        if (!is_new && begins_with(other, beginning) && !std::filesystem::remove(other, error)) {
            throw FileError(fmt::format("cannot remove {} of an earlier run: {}", other.string(),
                                        error.message()));
        }
    }
    nmbcgen::publish(files);
    for (const char* const ending : set_.pictures) {  // they show an earlier run
        std::error_code ignored;
        if (std::filesystem::is_regular_file(path(ending), ignored)) {
            std::filesystem::remove(path(ending), ignored);
        }
    }
}

/// Growing files and copies of them that no process has open.
void RunFiles::remove_leftovers() const {
    std::vector<Kind> kinds{{".csv", ""}, {".checkpoint", ""}};
    kinds.insert(kinds.end(), set_.others.begin(), set_.others.end());
    const auto own = marks();
    const auto is_own = [&](const std::string& name) {
        return std::ranges::find(own, name, &Journal::Mark::name) != own.end();
    };
    for (const auto& [ending, beginning] : kinds) {
        nmbcrun::remove_leftovers(path(ending), ending == ".h5" ? "" : beginning, is_own);
    }
}

std::vector<std::vector<double>> RunFiles::rows(std::size_t all, std::size_t some) const {
    const std::size_t every = std::max<std::size_t>(1, all / some);
    std::vector<std::vector<double>> rows;
    read_energies(
        journals_.front().journal->source(), set_.energies_header,
        [&](std::size_t row) { return row % every == 0 || row + 1 == all; },
        [&](const std::vector<double>& row) { rows.push_back(row); });
    return rows;
}

std::string RunFiles::listed() const {
    std::string lines;
    for (const auto& [label, journal] : journals_) {
        lines += fmt::format("{:<12} {}\n", label, journal->path().string());
    }
    return lines;
}

}  // namespace nmbcrun
