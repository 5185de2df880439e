// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <string_view>
#include <utility>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/csv.hpp"
#include "tools/nmbcrun/output/energies_file.hpp"
#include "tools/nmbcrun/output/snapshots.hpp"

namespace nmbcrun {
namespace {

std::string probes_header(const std::vector<std::size_t>& probes) {
    std::string header = "time";
    for (const std::size_t node : probes) {
        header += fmt::format(",u{0},v{0}", node + 1);
    }
    return header + "\n";
}

/// The energies of a run that goes on.
constexpr const char* growing = ".csv.part";

/// What not every run of a name publishes, and how such a file begins.
constexpr std::pair<const char*, std::string_view> optional_files[] = {
    {"_probes.csv", "time,u"}, {"_field.csv", field_header}, {".h5", "\x89HDF\r\n\x1a\n"}};

bool begins_with(const std::filesystem::path& path, std::string_view beginning) {
    std::string found(beginning.size(), '\0');
    std::ifstream stream(path, std::ios::binary);
    return stream.read(found.data(), std::streamsize(found.size())) && found == beginning;
}

/// The files that a scene is read from, besides its own.
std::vector<std::filesystem::path> inputs(const Scene& scene) {
    std::vector<std::filesystem::path> files = scene.table_files;
    if (scene.initial) {
        files.push_back(scene.initial->file);
    }
    if (scene.force) {
        files.push_back(scene.force->file);
    }
    for (const Boundary& end : {scene.left, scene.right}) {
        if (end.value) {
            files.push_back(end.value->file);
        }
    }
    return files;
}

}  // namespace

Recorder::Recorder(Scene scene, const nmbc::Chain& chain, std::filesystem::path folder,
                   std::string_view about)
    : scene_(std::move(scene)), folder_(std::move(folder)) {
    require_free_names();
    energies_ = std::make_unique<Journal>(path(".csv"));
    energies_->append(energies_head(about));
    if (!scene_.probes.empty()) {
        probed_ = std::make_unique<Journal>(path("_probes.csv"));
        probed_->append(probes_header(scene_.probes));
    }
    if (scene_.snapshots > 0) {
        snapshots_ = std::make_unique<Journal>(path(".h5"));
        append_snapshot(*snapshots_, chain);
    }
    for (Journal* const journal : journals()) {
        journal->source();  // what cannot be written is known before the first step
    }
    link_growing();
}

Recorder::Recorder(Scene scene, std::filesystem::path folder,
                   const std::vector<Journal::Mark>& marks)
    : scene_(std::move(scene)), folder_(std::move(folder)) {
    require_free_names();
    auto mark = marks.begin();
    const auto next = [&](const char* ending) {
        if (mark == marks.end()) {
            throw FileError("the checkpoint has fewer files than its scene");
        }
        return std::make_unique<Journal>(path(ending), *mark++);
    };
    energies_ = next(".csv");
    if (!scene_.probes.empty()) {
        probed_ = next("_probes.csv");
    }
    if (scene_.snapshots > 0) {
        snapshots_ = next(".h5");
    }
    link_growing();
}

Recorder::~Recorder() {
    std::error_code ignored;
    std::filesystem::remove(path(growing), ignored);
}

/// Where the file system knows no links there is none.
void Recorder::link_growing() const {
    std::error_code ignored;
    std::filesystem::remove(path(growing), ignored);
    std::filesystem::create_symlink(energies_->source().filename(), path(growing), ignored);
}

std::filesystem::path Recorder::path(const char* ending) const {
    return folder_ / (scene_.name + ending);
}

std::vector<Journal*> Recorder::journals() const {
    std::vector<Journal*> all{energies_.get()};
    for (Journal* const journal : {probed_.get(), snapshots_.get()}) {
        if (journal != nullptr) {
            all.push_back(journal);
        }
    }
    return all;
}

/// Of all files, whatever the scene asks for: those it does not are removed at the end.
void Recorder::require_free_names() const {
    for (const char* const ending : {".csv", "_probes.csv", ".h5", "_field.csv"}) {
        const std::filesystem::path name = path(ending);
        nmbcgen::require_replaceable(name);
        for (const std::filesystem::path& input : inputs(scene_)) {
            std::error_code none;  // of them is there
            if (std::filesystem::equivalent(input, name, none)) {
                throw SceneError(
                    fmt::format("the scene reads {}, which this run would replace or remove; "
                                "another output.name or --out is needed",
                                name.string()));
            }
        }
    }
}

void Recorder::record(const Sample& sample, const nmbc::Chain& chain) {
    energies_->append(energies_row(sample));
    if (!probed_) {
        return;
    }
    std::string row = fmt::format("{:.10g}", chain.time());
    for (const std::size_t node : scene_.probes) {
        const std::size_t entry = chain.first_interior() + node;
        row += fmt::format(",{},{}", chain.displacement()[entry], chain.velocity()[entry]);
    }
    probed_->append(row + "\n");
}

void Recorder::look(const nmbc::Chain& chain) {
    if (snapshots_ && chain.steps() % scene_.snapshots == 0) {
        append_snapshot(*snapshots_, chain);
    }
}

void Recorder::sync() {
    for (Journal* const journal : journals()) {
        journal->sync();
    }
}

std::vector<Journal::Mark> Recorder::marks() const {
    std::vector<Journal::Mark> marks;
    for (const Journal* const journal : journals()) {
        marks.push_back(journal->mark());
    }
    return marks;
}

void Recorder::keep(bool kept) {
    for (Journal* const journal : journals()) {
        journal->keep(kept);
    }
}

void Recorder::publish(const nmbc::Chain& chain, bool at_end) {
    std::vector<nmbcgen::NewFile> files;
    files.push_back(energies_->copy());
    if (probed_) {
        files.push_back(probed_->copy());
    }
    if (snapshots_) {
        files.push_back(write_snapshots(*snapshots_, *energies_, chain.parameters()));
    }
    if (at_end && scene_.field) {
        files.push_back(write_field(path("_field.csv"), chain));
    }
    remove_others(files);
    nmbcgen::publish(files);
}

/// Only what is a file of that kind: NAME_field.csv can be the energies of a scene of that name.
void Recorder::remove_others(const std::vector<nmbcgen::NewFile>& files) const {
    for (const auto& [ending, beginning] : optional_files) {
        const std::filesystem::path other = path(ending);
        const bool is_new = std::ranges::find(files, other, &nmbcgen::NewFile::path) != files.end();
        std::error_code error;
        if (!is_new && begins_with(other, beginning) && !std::filesystem::remove(other, error)) {
            throw FileError(fmt::format("cannot remove {} of an earlier run: {}", other.string(),
                                        error.message()));
        }
    }
}

/// Growing files and copies of them that no process has open.
void Recorder::remove_leftovers() const {
    std::vector<std::pair<std::string, std::string_view>> kinds{{".csv", ""}, {".checkpoint", ""}};
    kinds.insert(kinds.end(), std::begin(optional_files), std::end(optional_files));
    const auto own = marks();
    const auto is_own = [&](const std::string& name) {
        return std::ranges::find(own, name, &Journal::Mark::name) != own.end();
    };
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
        const std::string name = entry.path().filename().string();
        for (const auto& [ending, beginning] : kinds) {
            if (name.starts_with(scene_.name + ending + ".new-") && !is_own(name) &&
                (beginning.empty() || ending == ".h5" || begins_with(entry.path(), beginning))) {
                nmbcgen::remove_unless_open(entry.path());
            }
        }
    }
}

std::vector<Sample> Recorder::samples(std::size_t rows) const {
    const std::size_t every = std::max<std::size_t>(1, rows / 12);
    std::vector<Sample> samples;
    read_energies(
        energies_->source(), energies_header,
        [&](std::size_t row) { return row % every == 0 || row + 1 == rows; },
        [&](const std::vector<double>& row) { samples.push_back(sample_of(row)); });
    return samples;
}

std::string Recorder::files() const {
    std::string lines = fmt::format("energies     {}\n", energies_->path().string());
    if (probed_) {
        lines += fmt::format("probes       {}\n", probed_->path().string());
    }
    if (snapshots_) {
        lines += fmt::format("snapshots    {}\n", snapshots_->path().string());
    }
    if (scene_.field) {
        lines += fmt::format("field        {}\n", path("_field.csv").string());
    }
    return lines;
}

}  // namespace nmbcrun
