// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/chain_files.hpp"

#include <fmt/format.h>

#include <utility>

#include "tools/nmbcrun/output/csv.hpp"
#include "tools/nmbcrun/output/energies_file.hpp"
#include "tools/nmbcrun/output/gnuplot.hpp"
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

}  // namespace

ChainFiles::ChainFiles(const Scene& scene, const std::filesystem::path& folder,
                       std::string_view about, std::vector<Journal::Mark> marks)
    : RunFiles({.folder = folder,
                .name = scene.name,
                .energies_header = energies_header,
                .others = {{"_probes.csv", "time,u"},
                           {"_field.csv", field_header},
                           {".h5", "\x89HDF\r\n\x1a\n"}},
                .pictures = pictures_of_chains,
                .inputs = inputs_of(scene)},
               about, std::move(marks)),
      probes_(scene.probes),
      has_field_(scene.field) {
    if (!probes_.empty()) {
        probed_ = &open("probes", "_probes.csv", probes_header(probes_));
    }
    if (scene.snapshots > 0) {
        snapshots_ = &open("snapshots", ".h5", "");
    }
    begin();
}

void ChainFiles::record(const Sample& sample, const nmbc::Chain& chain) {
    energies_journal().append(energies_row(sample));
    if (probed_ == nullptr) {
        return;
    }
    std::string row = fmt::format("{:.10g}", chain.time());
    for (const std::size_t node : probes_) {
        const std::size_t entry = chain.first_interior() + node;
        row += fmt::format(",{},{}", chain.displacement()[entry], chain.velocity()[entry]);
    }
    probed_->append(row + "\n");
}

void ChainFiles::take_snapshot(const nmbc::Chain& chain) {
    append_snapshot(*snapshots_, chain);
}

void ChainFiles::publish(const nmbc::Chain& chain, bool at_end) {
    std::vector<nmbcgen::NewFile> files;
    files.push_back(energies_journal().copy());
    if (probed_ != nullptr) {
        files.push_back(probed_->copy());
    }
    if (snapshots_ != nullptr) {
        files.push_back(write_snapshots(*snapshots_, energies_journal(), chain.parameters()));
    }
    if (at_end && has_field_) {
        files.push_back(write_field(path("_field.csv"), chain));
    }
    RunFiles::publish(std::move(files));
}

std::string ChainFiles::listed() const {
    return RunFiles::listed() +
           (has_field_ ? fmt::format("{:<12} {}\n", "field", path("_field.csv").string()) : "");
}

}  // namespace nmbcrun
