// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "generator/support/files.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/energies_file.hpp"
#include "tools/nmbcrun/scene/csv_columns.hpp"

namespace nmbcrun {
namespace {

constexpr std::string_view plane_energies_header =
    "time,kinetic,strain,stabilisation,total,ledger,work,left_side,right_side,bottom_side,top_side,"
    "fracture,drift";

std::string probes_header(const PlaneScene& scene) {
    std::string header = "time";
    for (const auto& [x, y] : scene.probes) {
        header += fmt::format(",ux_{0}_{1},uy_{0}_{1},vx_{0}_{1},vy_{0}_{1}", x + 1, y + 1);
    }
    return header + "\n";
}

std::vector<std::string> crack_columns(const CrackFront& front) {
    std::vector<std::string> names{"time", "broken"};
    for (std::size_t end = 1; end <= front.ends().size(); ++end) {
        for (const char* const name : {"reach", "X", "Y", "branches"}) {
            names.push_back(fmt::format("{}_{}", name, end));
        }
    }
    return names;
}

}  // namespace

PlaneFiles::PlaneFiles(const PlaneSimulation& simulation, std::filesystem::path folder)
    : folder_(std::move(folder)),
      name_(simulation.scene().name),
      snapshots_(simulation.scene(), folder_) {
    for (const char* const ending : {".csv", "_probes.csv", "_cracks.csv"}) {
        nmbcgen::require_replaceable(path(ending));
    }
    if (simulation.scene().fracture) {
        front_.emplace(simulation.scene());
    }
}

PlaneFiles::PlaneFiles(const PlaneSimulation& simulation, std::filesystem::path folder,
                       std::string_view about)
    : PlaneFiles(simulation, std::move(folder)) {
    snapshots_.start_anew();
    energies_ = std::make_unique<Journal>(path(".csv"));
    energies_->append(energies_head(about, plane_energies_header));
    if (!simulation.scene().probes.empty()) {
        probed_ = std::make_unique<Journal>(path("_probes.csv"));
        probed_->append(probes_header(simulation.scene()));
    }
    if (front_) {
        cracked_ = std::make_unique<Journal>(path("_cracks.csv"));
        cracked_->append(fmt::format("{}\n", fmt::join(crack_columns(*front_), ",")));
    }
    for (Journal* const journal : journals()) {
        journal->source();  // what cannot be written is known before the first step
    }
}

PlaneFiles::PlaneFiles(const PlaneSimulation& simulation, std::filesystem::path folder,
                       const std::vector<Journal::Mark>& marks)
    : PlaneFiles(simulation, std::move(folder)) {
    const bool has_probes = !simulation.scene().probes.empty();
    if (marks.size() != 1U + (has_probes ? 1U : 0U) + (front_ ? 1U : 0U)) {
        throw FileError("the checkpoint has other files than its scene");
    }
    energies_ = std::make_unique<Journal>(path(".csv"), marks[0]);
    if (has_probes) {
        probed_ = std::make_unique<Journal>(path("_probes.csv"), marks[1]);
    }
    if (front_) {
        cracked_ = std::make_unique<Journal>(path("_cracks.csv"), marks.back());
    }
    snapshots_.go_on(simulation.plane().steps(), simulation.plan().time_step);
}

std::vector<Journal*> PlaneFiles::journals() const {
    std::vector<Journal*> all{energies_.get()};
    if (probed_) {
        all.push_back(probed_.get());
    }
    if (cracked_) {
        all.push_back(cracked_.get());
    }
    return all;
}

std::vector<Journal::Mark> PlaneFiles::marks() const {
    std::vector<Journal::Mark> marks;
    for (const Journal* const journal : journals()) {
        marks.push_back(journal->mark());
    }
    return marks;
}

void PlaneFiles::sync() {
    for (Journal* const journal : journals()) {
        journal->sync();
    }
}

void PlaneFiles::keep(bool kept) {
    snapshots_.keep(kept);
    for (Journal* const journal : journals()) {
        journal->keep(kept);
    }
}

std::vector<std::vector<double>> PlaneFiles::rows(std::size_t wanted) const {
    std::vector<std::vector<double>> all;
    read_energies(
        energies_->source(), plane_energies_header, [](std::size_t) { return true; },
        [&](const std::vector<double>& row) { all.push_back(row); });
    const std::size_t every = std::max<std::size_t>(1, all.size() / wanted);
    std::vector<std::vector<double>> some;
    for (std::size_t row = 0; row < all.size(); ++row) {
        if (row % every == 0 || row + 1 == all.size()) {
            some.push_back(all[row]);
        }
    }
    return some;
}

std::vector<PlaneFiles::CrackRow> PlaneFiles::crack_rows() const {
    const auto columns = read_columns(cracked_->source(), crack_columns(*front_));
    std::vector<CrackRow> rows(columns[0].size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].time = columns[0][i];
        rows[i].broken = columns[1][i];
        for (std::size_t end = 0; end < front_->ends().size(); ++end) {
            rows[i].reach.push_back(columns[2 + 4 * end][i]);
            rows[i].branches.push_back(columns[5 + 4 * end][i]);
        }
    }
    return rows;
}

std::vector<CrackGrowth> PlaneFiles::growth(const PlaneSimulation& simulation) const {
    return front_->look([&](std::size_t x, std::size_t y) { return simulation.damage(x, y); });
}

void PlaneFiles::record(const PlaneSimulation& simulation, const nmbc::PlaneEnergies& e,
                        const PlaneBalance& balance) {
    const nmbc::Plane& plane = simulation.plane();
    energies_->append(fmt::format("{:.10g},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                                  plane.time() - simulation.plan().time_step / 2, e.kinetic,
                                  e.strain, e.stabilisation, e.total(), balance.energy,
                                  balance.work, balance.left[0], balance.left[1], balance.left[2],
                                  balance.left[3], balance.fracture, balance.drift));
    if (cracked_) {
        std::string row = fmt::format("{:.10g},{:.0f}", plane.time(), plane.broken());
        for (const CrackGrowth& of_end : growth(simulation)) {
            row += fmt::format(",{:.9g},{:.9g},{:.9g},{}", of_end.reach, of_end.tip[0],
                               of_end.tip[1], of_end.branches.size());
        }
        cracked_->append(row + "\n");
    }
    if (!probed_) {
        return;
    }
    std::string row = fmt::format("{:.10g}", plane.time());
    for (const auto& [x, y] : simulation.scene().probes) {
        const std::size_t entry = simulation.entry(x, y);
        row +=
            fmt::format(",{},{},{},{}", plane.displacement(0)[entry], plane.displacement(1)[entry],
                        plane.velocity(0)[entry], plane.velocity(1)[entry]);
    }
    probed_->append(row + "\n");
}

void PlaneFiles::publish(const PlaneSimulation& simulation, bool at_end) {
    std::vector<nmbcgen::NewFile> files;
    files.push_back(energies_->copy());
    if (probed_) {
        files.push_back(probed_->copy());
    }
    if (cracked_) {
        files.push_back(cracked_->copy());
    }
    nmbcgen::publish(files);
    if (!probed_) {
        std::filesystem::remove(path("_probes.csv"));
    }
    if (!cracked_) {
        std::filesystem::remove(path("_cracks.csv"));
    }
    snapshots_.publish(simulation, at_end);
}

void PlaneFiles::remove_leftovers() const {
    const std::vector<Journal::Mark> own = marks();
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
        const std::string name = entry.path().filename().string();
        const bool is_of_this_name = std::ranges::any_of(
            std::array{".csv", "_probes.csv", "_cracks.csv", ".checkpoint"},
            [&](const char* ending) { return name.starts_with(name_ + ending + ".new-"); });
        if (is_of_this_name && std::ranges::find(own, name, &Journal::Mark::name) == own.end()) {
            nmbcgen::remove_unless_open(entry.path());
        }
    }
}

std::string PlaneFiles::listed() const {
    std::string lines = fmt::format("energies     {}\n", energies_->path().string());
    if (probed_) {
        lines += fmt::format("probes       {}\n", probed_->path().string());
    }
    if (cracked_) {
        lines += fmt::format("cracks       {}\n", cracked_->path().string());
    }
    return lines + snapshots_.listed();
}

}  // namespace nmbcrun
