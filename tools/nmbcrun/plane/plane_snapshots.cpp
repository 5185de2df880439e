// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_snapshots.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "generator/support/files.hpp"

namespace nmbcrun {
namespace {

/// Of any format.
constexpr std::array<std::string_view, 5> endings{".pvd", ".xdmf", ".h5", "_field.vti",
                                                  "_field.h5"};

/// Throws FileError where there is an error: that one cannot do this with the file.
void require_done(std::error_code error, std::string_view what, const std::filesystem::path& path) {
    if (error) {
        throw nmbcgen::FileError(
            fmt::format("cannot {} {}: {}", what, path.string(), error.message()));
    }
}

/// What its name says of a file of a folder of snapshots.
struct SnapshotFile {
    std::size_t step = 0;
    bool is_whole = true;  // otherwise a killed process has left it unfinished
};

/// Nothing for a folder, and for what has another name than snapshots of any format.
std::optional<SnapshotFile> snapshot_file(const std::filesystem::directory_entry& entry) {
    constexpr std::ptrdiff_t digits = 9;
    const std::string name = entry.path().filename().string();
    const std::string whole = name.substr(0, name.find(".new-"));
    const char* const end = whole.data() + whole.size();
    std::size_t step = 0;
    const auto [dot, error] = std::from_chars(whole.data(), end, step);
    const std::string_view ending(dot, std::size_t(end - dot));
    std::error_code ignored;
    if (error != std::errc() || dot - whole.data() < digits ||
        (ending != ".vti" && ending != ".h5") || entry.is_directory(ignored)) {
        return std::nullopt;
    }
    return SnapshotFile{.step = step, .is_whole = whole == name};
}

bool is_folder(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::is_directory(path, ignored);
}

/// Removes of the snapshots in a folder, which may be missing, those that are to go, and nothing
/// else in it. Gives why one of them is still there.
template <class IsToGo>
std::error_code clear(const std::filesystem::path& folder, IsToGo is_to_go) {
    std::error_code problem;
    if (!is_folder(folder)) {
        return problem;
    }
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const auto file = snapshot_file(*entry);
        std::error_code stays;
        if (file && is_to_go(*file)) {
            std::filesystem::remove(entry->path(), stays);
        }
        problem = stays ? stays : problem;
    }
    return error ? error : problem;
}

/// With their folder, where nothing else is in that.
std::error_code remove_snapshots(const std::filesystem::path& folder) {
    const std::error_code problem = clear(folder, [](const SnapshotFile&) { return true; });
    if (is_folder(folder)) {
        std::error_code not_empty;
        std::filesystem::remove(folder, not_empty);
    }
    return problem;
}

/// Moves what else is in a folder of snapshots into another one. What a link leads to stays there.
/// Throws FileError, before it moves anything where something is in the way.
void move_others(const std::filesystem::path& from, const std::filesystem::path& to) {
    std::error_code error;
    if (!std::filesystem::is_directory(std::filesystem::symlink_status(from, error))) {
        return;
    }
    std::vector<std::filesystem::path> others;
    for (std::filesystem::directory_iterator entry(from, error), end; !error && entry != end;
         entry.increment(error)) {
        if (snapshot_file(*entry)) {
            continue;
        }
        std::error_code ignored;
        const std::filesystem::path there = to / entry->path().filename();
        if (std::filesystem::exists(std::filesystem::symlink_status(there, ignored))) {
            throw nmbcgen::FileError(
                fmt::format("{} is in the way of {}", entry->path().string(), there.string()));
        }
        others.push_back(entry->path());
    }
    require_done(error, "read", from);
    for (const std::filesystem::path& other : others) {
        std::filesystem::rename(other, to / other.filename(), error);
        require_done(error, "move", other);
    }
}

}  // namespace

std::vector<std::filesystem::path> PlaneSnapshots::replaced(const PlaneScene& scene,
                                                            const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> paths{folder / (scene.name + "_snapshots")};
    for (const std::string_view ending : endings) {
        paths.push_back(folder / (scene.name + std::string(ending)));
    }
    return paths;
}

PlaneSnapshots::PlaneSnapshots(const PlaneScene& scene, std::filesystem::path folder,
                               const std::string& own_ending)
    : folder_(std::move(folder)),
      name_(scene.name),
      format_(scene.field_format),
      every_(scene.snapshots),
      has_field_(scene.field),
      series_(series_name(scene)),
      growing_(path("_snapshots").filename().string() + own_ending) {
    for (const std::string_view ending : endings) {
        nmbcgen::require_replaceable(path(ending));
    }
}

PlaneSnapshots::~PlaneSnapshots() {
    if (!is_kept_) {
        remove_snapshots(growing());
    }
}

void PlaneSnapshots::begin(std::size_t step, double time_step, double bytes) {
    if (step == 0) {
        is_kept_ = false;
        require_done(remove_snapshots(growing()), "clear", growing());
        return;
    }
    for (std::size_t at = 0; every_ > 0 && at <= step; at += every_) {
        snapshots_.push_back({double(at) * time_step, file_of(at)});
    }
    const std::string problem = what_lacks(growing(), bytes);
    if (!problem.empty()) {
        const std::filesystem::path published = path("_snapshots");
        if (is_folder(growing()) || !what_lacks(published, bytes).empty()) {
            throw nmbcgen::FileError(problem + ": the run cannot go on from its checkpoint");
        }
        std::error_code error;
        std::filesystem::rename(published, growing(), error);
        require_done(error, "move", published);
    }
    // A killed process has gone on behind its last checkpoint, this run may end before that place.
    const auto is_behind = [&](const SnapshotFile& file) {
        return !file.is_whole || file.step > step;
    };
    require_done(clear(growing(), is_behind), "clear", growing());
}

void PlaneSnapshots::remove_leftovers() const {
    const std::string beginning = path("_snapshots").filename().string() + ".new-";
    std::error_code error;  // a folder that cannot be listed keeps what it has
    for (std::filesystem::directory_iterator entry(folder_.empty() ? "." : folder_, error), end;
         !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with(beginning) && name != growing_) {
            remove_snapshots(entry->path());
        }
    }
}

std::string PlaneSnapshots::what_lacks(const std::filesystem::path& folder, double bytes) const {
    for (const Snapshot& snapshot : snapshots_) {
        const std::filesystem::path file = folder / snapshot.file.filename();
        std::error_code missing;
        const auto size = std::filesystem::file_size(file, missing);
        if (missing || double(size) < bytes) {
            return file.string() + (missing ? " is missing" : " is too short");
        }
    }
    return "";
}

std::filesystem::path PlaneSnapshots::path(std::string_view ending) const {
    return folder_ / (name_ + std::string(ending));
}

std::filesystem::path PlaneSnapshots::field() const {
    return path(fmt::format("_field{}", extension_of(format_)));
}

/// Relative to the folder.
std::filesystem::path PlaneSnapshots::file_of(std::size_t step) const {
    return std::filesystem::path(name_ + "_snapshots") /
           fmt::format("{:09}{}", step, extension_of(format_));
}

void PlaneSnapshots::take(const PlaneSimulation& simulation) {
    const std::filesystem::path relative = file_of(simulation.plane().steps());
    write_fields(simulation, growing() / relative.filename());
    snapshots_.push_back({simulation.plane().time(), relative});
}

std::vector<nmbcgen::NewFile> PlaneSnapshots::new_field(const PlaneSimulation& simulation) const {
    std::vector<nmbcgen::NewFile> files;
    if (has_field_) {
        files.push_back(new_fields(simulation, field()));
    }
    return files;
}

void PlaneSnapshots::publish(const PlaneSimulation& simulation,
                             std::vector<nmbcgen::NewFile> field) {
    // What else is in the folder of the earlier ones goes with the folder of these: at any time one
    // of both folders has all of these, from which a run can go on.
    const std::filesystem::path published = path("_snapshots");
    std::error_code error;
    if (!snapshots_.empty()) {
        move_others(published, growing());
    }
    require_done(remove_snapshots(published), "clear", published);
    for (const std::string_view ending : endings) {
        std::filesystem::remove(path(ending), error);
        require_done(error, "remove", path(ending));
    }
    if (!snapshots_.empty()) {
        std::filesystem::rename(growing(), published, error);
        require_done(error, "write", published);
        write_series(simulation, folder_, snapshots_);
    }
    nmbcgen::publish(field);
}

std::string PlaneSnapshots::listed() const {
    std::string lines;
    if (!snapshots_.empty()) {
        lines += fmt::format("snapshots    {}\n", (folder_ / series_).string());
    }
    if (has_field_) {
        lines += fmt::format("field        {}\n", field().string());
    }
    return lines;
}

}  // namespace nmbcrun
