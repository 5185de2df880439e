// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "generator/names/printable.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/energies_file.hpp"
#include "tools/nmbcrun/output/gnuplot.hpp"
#include "tools/nmbcrun/output/share_gone.hpp"
#include "tools/nmbcrun/output/step_warnings.hpp"
#include "tools/nmbcrun/output/stoppable_run.hpp"
#include "tools/nmbcrun/output/warnings.hpp"
#include "tools/nmbcrun/plane/crack_report.hpp"
#include "tools/nmbcrun/plane/plane_files.hpp"
#include "tools/nmbcrun/plane/plane_plan.hpp"
#include "tools/nmbcrun/plane/plane_report.hpp"
#include "tools/nmbcrun/plane/plane_sides.hpp"
#include "tools/nmbcrun/plane/side_prospect.hpp"

namespace nmbcrun {
namespace {

class PlaneRun : public StoppableRun {
  public:
    /// Between sides_of() the scene.
    PlaneRun(const PlaneScene& scene, const nmbc::PlaneSides& sides, const RunOptions& options);

    const PlaneSimulation& simulation() const { return simulation_; }

    void print();

  private:
    std::size_t steps() const override { return simulation_.plane().steps(); }
    double time() const override { return simulation_.plane().time(); }
    void advance(std::size_t steps) override { simulation_.advance(steps); }
    std::vector<std::vector<double>> state() const override { return simulation_.state(); }
    void begin() override { look(true); }
    void look(bool is_row) override;
    void take_snapshot() override { files_->take_snapshot(simulation_); }
    RunFiles& files() override { return *files_; }
    void publish(bool at_end) override { files_->publish(simulation_, at_end); }

    void judge(double energy);

    PlaneSimulation simulation_;
    std::optional<PlaneFiles> files_{};
};

PlaneRun::PlaneRun(const PlaneScene& scene, const nmbc::PlaneSides& sides,
                   const RunOptions& options)
    : StoppableRun(scene, options), simulation_(scene, sides) {
    const PlanePlan& plan = simulation_.plan();
    const auto from =
        claim(identity_of(scene, has_open_layer(scene), plan, inputs_of(scene)), plan);
    if (from) {
        simulation_.resume(from->steps, from->state);
    }
    files_.emplace(simulation_, options.folder, about(heading_of(simulation_), plan, "thickness"),
                   from ? from->journals : std::vector<Journal::Mark>());
}

void PlaneRun::look(bool is_row) {
    const nmbc::PlaneEnergies energies = simulation_.energies();
    judge(energies.total());
    if (is_row) {
        const PlaneBalance balance = simulation_.balance();
        highlights().drift = std::max(highlights().drift, std::abs(balance.drift));
        files_->record(simulation_, energies, balance);
    }
}

/// Energy may also come in from layers beside the scene's nodes.
void PlaneRun::judge(double energy) {
    const auto unstable = [&](const std::string& what) {
        return Unstable(fmt::format("{} at {}. Energies up to there: {}", what, place(),
                                    files_->energies().string()));
    };
    if (!std::isfinite(energy)) {
        throw unstable("the energy is not finite");
    }
    // Of a part of the plane, bonds of weights below 0 may make it a little less than 0.
    constexpr double little = 0.1;
    const double peak = std::max(highlights().peak, energy);
    if (energy < -little * peak) {
        throw unstable(fmt::format("the energy is below 0, {:.3g} of its peak,", energy / peak));
    }
    const double between = double(look_every) * simulation_.plan().time_step;
    const bool is_driven = steps() == 0 || simulation_.is_driven(std::max(0.0, time() - between));
    if (has_grown(energy, is_driven) && std::abs(simulation_.times_supplied()) > 10) {
        const PlaneScene& scene = simulation_.scene();
        throw unstable(growth(energy, scene.force || scene.drive || !scene.loads.empty()) + ",");
    }
}

void PlaneRun::print() {
    const double peak = highlights().peak;
    if (peak == 0) {
        throw Unstable(fmt::format(
            "nothing moved at any time: no source acts before time.end, or they cancel. "
            "Energies: {}",
            files_->energies().string()));
    }
    const PlanePlan& plan = simulation_.plan();
    const std::size_t all =
        1 + (plan.steps + simulation_.scene().every - 1) / simulation_.scene().every;
    const std::vector<std::vector<double>> rows = files_->rows(all, printed_rows);
    if (!options().quiet) {
        fmt::print("{:>10}  {:>12}  {:>12}  {:>14}  {:>12}  {:>10}\n", "time", "kinetic", "strain",
                   "stabilisation", "total", "of peak");
        for (const std::vector<double>& row : rows) {
            fmt::print("{:10.4g}  {:12.4e}  {:12.4e}  {:14.4e}  {:12.4e}  {:10.2e}\n", row[0],
                       row[1], row[2], row[3], row[4], row[4] / peak);
        }
        fmt::print("\n");
    }
    double least = HUGE_VAL;
    for (const std::vector<double>& row : rows) {
        least = std::min(least, row[4] > 0 ? row[4] : least);
    }
    if (const std::string warning = warning_of_strains(simulation_, "at the end");
        !warning.empty()) {
        print_warnings({warning});
    }
    print_warnings(simulation_.torn_loads());
    if (rows.back()[4] > 10 * least && !simulation_.is_driven(simulation_.plane().time()) &&
        simulation_.scene().may_grow()) {
        print_warnings(
            {fmt::format("the energy has grown to {:.2g} times the least of the table: "
                         "its sides feed it",
                         rows.back()[4] / least)});
    }
    const PlaneBalance balance = simulation_.balance();
    fmt::print("energy left  {:.3e} of the peak\n", rows.back()[4] / peak);
    if (std::isfinite(balance.drift)) {
        const auto [whole, name_of_whole] = whole_of(simulation_.supplied(), peak);
        std::vector<std::string> parts;
        for (std::size_t i = 0; i < balance.left.size(); ++i) {
            // Beyond an extended side the lattice goes on: what has come through is still in it.
            const bool is_measured = simulation_.scene().sides[i].kind != SideKind::extended;
            parts.push_back(fmt::format("{} {}",
                                        is_measured ? share_gone(balance.left[i] / whole) : "-",
                                        plane_side_names[i]));
        }
        if (balance.damped != 0) {
            parts.push_back(fmt::format("{:.3e} by damping", balance.damped / whole));
        }
        if (balance.fracture != 0) {
            parts.push_back(fmt::format("{:.3e} by fracture", balance.fracture / whole));
        }
        fmt::print("went out     {}, of {}\n", fmt::join(parts, ", "), name_of_whole);
        fmt::print("ledger drift {:.1e} of the peak\n", highlights().drift / peak);
    }
    if (simulation_.scene().fracture) {
        fmt::print("{}", crack_report(simulation_, *files_));
    }
    fmt::print("{}", nmbcgen::printable_lines(files_->listed()));
}

}  // namespace

void run_plane(const PlaneScene& scene, const RunOptions& options) {
    const SceneSides sides = sides_of(scene, options.quiet);
    PlaneRun run(scene, sides.all, options);
    const nmbc::Grid grid = run.simulation().plane().grid();
    const double bytes = bytes_of_fields(run.simulation());
    const RunSize size{grid.nx * grid.ny, pace_of(scene), bytes, 4 * scene.probes.size(),
                       scene.field ? bytes : 0};
    run.require_possible(size);
    run.warn(warnings_of(run.simulation()), size);
    if (!options.quiet) {
        const PlanePlan& plan = run.simulation().plan();
        const std::string ends = prospect_of(scene, sides.passive);
        fmt::print("{}{}time      {} steps of {}{}\n\n", heading_of(run.simulation()),
                   ends.empty() ? "" : fmt::format("ends      {}\n", ends), plan.steps,
                   heading_of(plan), length_of_run(run.steps_left(size)));
        std::fflush(stdout);  // through a pipe, too, it is read before the run
    }
    run.to_the_end();
    run.print();
}

void draw_plane(const PlaneScene& scene, const std::filesystem::path& folder) {
    const auto file = [&](const char* ending) { return (folder / (scene.name + ending)).string(); };
    draw("energy.gp", {file("_energy"), file(".csv"), scene.title},
         {file("_energy.svg"), file("_energy.png")});
    const bool is_drawn = scene.field_format == FieldFormat::vtk;
    if (scene.fracture && scene.field && is_drawn) {
        draw("cracks.gp", {file("_cracks.png"), scene.title, file("")}, {file("_cracks.png")});
    } else if (scene.fracture) {
        fmt::print("no picture   of the cracks: it takes output.field in the format \"vtk\"\n");
    }
    if (scene.field && !scene.fracture && is_drawn) {
        draw("fields.gp", {file("_field"), file("_field.vti"), scene.title}, {file("_field.png")});
        draw("fields.gp", {file("_field_energy"), file("_field.vti"), scene.title, "energy"},
             {file("_field_energy.png")});
    } else if (scene.field && !scene.fracture) {
        fmt::print("no picture   of the field: its format is not \"vtk\"\n");
    }
    if (scene.snapshots > 0 && !is_drawn) {
        fmt::print("no picture   of the snapshots: their format is not \"vtk\"\n");
    } else if (scene.snapshots > 0) {
        draw("fields.gp", {file("_fields"), file(".pvd"), scene.title},
             {file("_fields.png"), file("_fields.gif")});
        draw("fields.gp", {file("_fields_energy"), file(".pvd"), scene.title, "energy"},
             {file("_fields_energy.png")});
    }
}

}  // namespace nmbcrun
