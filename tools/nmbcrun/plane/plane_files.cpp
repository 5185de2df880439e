// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
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

/// Of a folder that has snapshots, and of nothing else in it.
void remove_snapshots(const std::filesystem::path& folder) {
    if (!std::filesystem::is_directory(folder)) {
        return;
    }
    constexpr std::size_t digits = 9;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string stem = entry.path().stem().string();
        if (entry.path().extension() == ".vti" && stem.size() >= digits &&
            stem.find_first_not_of("0123456789") == std::string::npos) {
            std::filesystem::remove(entry.path());
        }
    }
    std::error_code not_empty;
    std::filesystem::remove(folder, not_empty);
}

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
      has_field_(simulation.scene().field) {
    for (const char* const ending : {".csv", "_probes.csv", "_cracks.csv", "_field.vti", ".pvd"}) {
        nmbcgen::require_replaceable(path(ending));
    }
    if (simulation.scene().fracture) {
        front_.emplace(simulation.scene());
    }
}

PlaneFiles::PlaneFiles(const PlaneSimulation& simulation, std::filesystem::path folder,
                       std::string_view about)
    : PlaneFiles(simulation, std::move(folder)) {
    remove_snapshots(growing());  // of a run that was killed
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
    if (!std::filesystem::exists(growing()) && std::filesystem::exists(path("_snapshots"))) {
        std::filesystem::rename(path("_snapshots"), growing());  // of a run that was stopped
    }
    const std::size_t every = simulation.scene().snapshots;
    for (std::size_t step = 0; every > 0 && step <= simulation.plane().steps(); step += every) {
        snapshots_.emplace_back(double(step) * simulation.plan().time_step, snapshot_name(step));
    }
}

PlaneFiles::~PlaneFiles() {
    if (!is_kept_) {
        try {
            remove_snapshots(growing());
        } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch): it stays then
        }
    }
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
    is_kept_ = kept;
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

/// Relative to the folder.
std::filesystem::path PlaneFiles::snapshot_name(std::size_t step) const {
    return std::filesystem::path(name_ + "_snapshots") / fmt::format("{:09}.vti", step);
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

void PlaneFiles::take_snapshot(const PlaneSimulation& simulation) {
    const std::filesystem::path relative = snapshot_name(simulation.plane().steps());
    nmbcgen::write_files({{growing() / relative.filename(), vti_text(simulation)}});
    snapshots_.emplace_back(simulation.plane().time(), relative);
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
    remove_snapshots(path("_snapshots"));
    std::filesystem::remove(path(".pvd"));
    if (!snapshots_.empty()) {
        std::filesystem::rename(growing(), path("_snapshots"));
        std::string text =
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" "
            "version=\"0.1\">\n<Collection>\n";
        for (const auto& [time, file] : snapshots_) {
            text += fmt::format("<DataSet timestep=\"{:.10g}\" file=\"{}\"/>\n", time,
                                file.generic_string());
        }
        nmbcgen::write_files({{path(".pvd"), text + "</Collection>\n</VTKFile>\n"}});
    }
    if (!at_end || !has_field_) {
        std::filesystem::remove(path("_field.vti"));
    } else {
        nmbcgen::write_files({{path("_field.vti"), vti_text(simulation)}});
    }
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
    if (!snapshots_.empty()) {
        lines += fmt::format("snapshots    {}\n", path(".pvd").string());
    }
    if (has_field_) {
        lines += fmt::format("field        {}\n", path("_field.vti").string());
    }
    return lines;
}

std::string vti_text(const PlaneSimulation& simulation) {
    static_assert(std::endian::native == std::endian::little);
    const PlaneScene& scene = simulation.scene();
    const nmbc::Plane& plane = simulation.plane();
    const std::size_t nx = scene.nodes[0];
    const std::size_t ny = scene.nodes[1];
    std::string arrays;  // their descriptions
    std::string data;
    const auto append = [&](const auto& value) {
        std::array<char, sizeof(value)> raw{};
        std::memcpy(raw.data(), &value, sizeof(value));
        data.append(raw.data(), raw.size());
    };
    const auto add = [&](const char* name, std::size_t components, const auto& append_node) {
        arrays += fmt::format(
            "<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" "
            "format=\"appended\" offset=\"{}\"/>\n",
            name, components, data.size());
        append(std::uint64_t(nx * ny * components * sizeof(double)));
        for (std::size_t y = 0; y < ny; ++y) {
            for (std::size_t x = 0; x < nx; ++x) {
                append_node(x, y);
            }
        }
    };
    for (const bool is_velocity : {false, true}) {
        add(is_velocity ? "velocity" : "displacement", 3, [&](std::size_t x, std::size_t y) {
            const std::size_t entry = simulation.entry(x, y);
            for (const std::size_t a : {0U, 1U}) {
                append(is_velocity ? plane.velocity(a)[entry] : plane.displacement(a)[entry]);
            }
            append(0.0);
        });
    }
    if (scene.fracture) {
        add("damage", 1, [&](std::size_t x, std::size_t y) { append(simulation.damage(x, y)); });
    }
    return fmt::format(
               "<?xml version=\"1.0\"?>\n"
               "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
               "header_type=\"UInt64\">\n"
               "<ImageData WholeExtent=\"0 {0} 0 {1} 0 0\" Origin=\"{2} {2} 0\" "
               "Spacing=\"{2} {2} {2}\">\n"
               "<FieldData><DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
               "format=\"ascii\">{3:.10g}</DataArray></FieldData>\n"
               "<Piece Extent=\"0 {0} 0 {1} 0 0\">\n<PointData Vectors=\"displacement\">\n{4}"
               "</PointData>\n</Piece>\n</ImageData>\n<AppendedData encoding=\"raw\">\n_",
               nx - 1, ny - 1, scene.spacing, plane.time(), arrays) +
           data + "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace nmbcrun
