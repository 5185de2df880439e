// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_snapshots.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>

#include "generator/support/files.hpp"

namespace nmbcrun {
namespace {

/// Of any format.
constexpr std::array<std::string_view, 5> endings{".pvd", ".xdmf", ".h5", "_field.vti",
                                                  "_field.h5"};

bool is_snapshot(const std::string& name) {
    constexpr std::size_t digits = 9;
    const std::size_t dot = name.find_first_not_of("0123456789");
    return dot != std::string::npos && dot >= digits &&
           (name.substr(dot) == ".vti" || name.substr(dot) == ".h5");
}

/// Of a folder that has snapshots what a killed process has left unfinished; the others, too, if
/// they are to go; and nothing else in it.
void clear(const std::filesystem::path& folder, bool of_snapshots) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        const std::size_t unfinished = name.find(".new-");
        if (is_snapshot(name.substr(0, unfinished)) &&
            (of_snapshots || unfinished != std::string::npos)) {
            std::filesystem::remove(entry.path());
        }
    }
}

/// With its folder, where nothing else is in that.
void remove_snapshots(const std::filesystem::path& folder) {
    if (!std::filesystem::is_directory(folder)) {
        return;
    }
    clear(folder, true);
    std::error_code not_empty;
    std::filesystem::remove(folder, not_empty);
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
        try {
            remove_snapshots(growing());
        } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch): it stays then
        }
    }
}

void PlaneSnapshots::begin(std::size_t step, double time_step, double bytes) {
    if (step == 0) {
        is_kept_ = false;
        remove_snapshots(growing());
        return;
    }
    for (std::size_t at = 0; every_ > 0 && at <= step; at += every_) {
        snapshots_.push_back({double(at) * time_step, file_of(at)});
    }
    const std::string problem = what_lacks(growing(), bytes);
    if (problem.empty()) {
        if (std::filesystem::is_directory(growing())) {
            clear(growing(), false);
        }
        return;
    }
    const std::filesystem::path published = path("_snapshots");
    if (std::filesystem::exists(growing()) || !what_lacks(published, bytes).empty()) {
        throw nmbcgen::FileError(problem + ": the run cannot go on from its checkpoint");
    }
    std::filesystem::rename(published, growing());
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

void PlaneSnapshots::publish(const PlaneSimulation& simulation, bool at_end) {
    remove_snapshots(path("_snapshots"));
    for (const std::string_view ending : endings) {
        std::filesystem::remove(path(ending));
    }
    if (!snapshots_.empty()) {
        std::filesystem::rename(growing(), path("_snapshots"));
        write_series(simulation, folder_, snapshots_);
    }
    if (at_end && has_field_) {
        write_fields(simulation, field());
    }
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
