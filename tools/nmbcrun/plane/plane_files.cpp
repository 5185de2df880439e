// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_files.hpp"

#include <fmt/format.h>

#include <utility>

#include "tools/nmbcrun/output/energies_file.hpp"
#include "tools/nmbcrun/output/gnuplot.hpp"
#include "tools/nmbcrun/scene/csv_columns.hpp"

namespace nmbcrun {
namespace {

constexpr std::string_view plane_energies_header =
    "time,kinetic,strain,stabilisation,total,ledger,work,left_side,right_side,bottom_side,top_side,"
    "damped,fracture,drift";

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

PlaneFiles::PlaneFiles(const PlaneSimulation& simulation, const std::filesystem::path& folder,
                       std::string_view about, std::vector<Journal::Mark> marks)
    : RunFiles({.folder = folder,
                .name = simulation.scene().name,
                .energies_header = plane_energies_header,
                .others = {{"_probes.csv", "time,ux"}, {"_cracks.csv", "time,broken"}},
                .pictures = pictures_of_planes,
                .inputs = inputs_of(simulation.scene()),
                .further = PlaneSnapshots::replaced(simulation.scene(), folder)},
               about, std::move(marks)),
      snapshots_(simulation.scene(), folder, own_ending()) {
    const PlaneScene& scene = simulation.scene();
    if (!scene.probes.empty()) {
        probed_ = &open("probes", "_probes.csv", probes_header(scene));
    }
    if (scene.fracture) {
        front_.emplace(scene);
        cracked_ = &open("cracks", "_cracks.csv",
                         fmt::format("{}\n", fmt::join(crack_columns(*front_), ",")));
    }
    RunFiles::begin();
    snapshots_.begin(simulation.plane().steps(), simulation.plan().time_step,
                     bytes_of_fields(simulation));
}

void PlaneFiles::keep(bool kept) {
    snapshots_.keep(kept);
    RunFiles::keep(kept);
}

void PlaneFiles::remove_leftovers() const {
    RunFiles::remove_leftovers();
    snapshots_.remove_leftovers();
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
    energies_journal().append(fmt::format(
        "{:.10g},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
        plane.time() - simulation.plan().time_step / 2, e.kinetic, e.strain, e.stabilisation,
        e.total(), balance.energy, balance.work, balance.left[0], balance.left[1], balance.left[2],
        balance.left[3], balance.damped, balance.fracture, balance.drift));
    if (cracked_ != nullptr) {
        std::string row = fmt::format("{:.10g},{:.0f}", plane.time(), plane.broken());
        for (const CrackGrowth& of_end : growth(simulation)) {
            row += fmt::format(",{:.9g},{:.9g},{:.9g},{}", of_end.reach, of_end.tip[0],
                               of_end.tip[1], of_end.branches.size());
        }
        cracked_->append(row + "\n");
    }
    if (probed_ == nullptr) {
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
    std::vector<nmbcgen::NewFile> field;
    if (at_end) {
        field = snapshots_.new_field(simulation);
    }
    RunFiles::publish(copies());
    snapshots_.publish(simulation, std::move(field));
}

std::string PlaneFiles::listed() const {
    return RunFiles::listed() + snapshots_.listed();
}

}  // namespace nmbcrun
