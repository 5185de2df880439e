// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generator/names/checksum.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/checkpoint.hpp"
#include "tools/nmbcrun/output/gnuplot.hpp"
#include "tools/nmbcrun/output/interrupt.hpp"
#include "tools/nmbcrun/output/progress.hpp"
#include "tools/nmbcrun/output/run_lock.hpp"
#include "tools/nmbcrun/output/sample.hpp"
#include "tools/nmbcrun/plane/crack_report.hpp"
#include "tools/nmbcrun/plane/plane_files.hpp"
#include "tools/nmbcrun/plane/plane_report.hpp"
#include "tools/nmbcrun/scene/regular_file.hpp"

namespace nmbcrun {
namespace {

constexpr std::size_t look_every = 10;  // steps; whatever is written, the peak is the same

std::map<std::string, std::string> identity(const PlaneSimulation& simulation) {
    const PlaneScene& scene = simulation.scene();
    auto keys = identity_of(scene.given, has_open_layer(scene), simulation.plan().steps,
                            simulation.plan().time_step);
    const auto add = [&keys](const std::filesystem::path& path) {
        constexpr std::uintmax_t most_bytes = 1'000'000'000;
        std::ifstream file = open_regular_file(path, most_bytes);
        const std::string text(std::istreambuf_iterator<char>(file), {});
        keys["the checksum of " + path.string()] = fmt::format("{:x}", nmbcgen::checksum(text));
    };
    if (scene.force && scene.force->history.history == History::file) {
        add(scene.force->history.file);
    }
    for (const PlaneLoad& load : scene.loads) {
        if (!load.file.empty()) {
            add(load.file);
        }
    }
    return keys;
}

class PlaneRun {
  public:
    PlaneRun(const PlaneScene& scene, const RunOptions& options)
        : simulation_(scene),
          options_(options),
          checkpoint_(options.folder / (scene.name + ".checkpoint")) {
        note_interrupts();  // up to here nothing was written
        nmbcgen::require_replaceable(checkpoint_);
        lock_.emplace(options.folder / (scene.name + ".lock"));
        if (options.resume) {
            const Checkpoint from = load_checkpoint(checkpoint_);
            require_resumable(identity(simulation_), simulation_.plan().steps, from, checkpoint_);
            std::vector<std::vector<double>> state = from.state;
            if (state.empty() || state.back().size() != 3) {
                throw FileError(
                    fmt::format("{} is no checkpoint of a plane", checkpoint_.string()));
            }
            highlights_ = {state.back()[0], state.back()[1], state.back()[2]};
            state.pop_back();
            simulation_.resume(from.steps, state);
            files_.emplace(simulation_, options.folder, from.journals);
            is_stored_ = true;
        } else {
            files_.emplace(
                simulation_, options.folder,
                fmt::format("nmbcrun   {}\n{}step      {}\nunits     those of the scene, "
                            "any consistent system; energies per thickness\n",
                            NMBC_VERSION, heading_of(simulation_), heading_of(simulation_.plan())));
        }
    }

    const PlaneSimulation& simulation() const { return simulation_; }

    void to_the_end();
    void print() const;
    std::string what_is_kept() const {
        return is_stored_ ? fmt::format("--resume goes on from {}", checkpoint_.string())
                          : "no checkpoint was stored, nothing is kept of this run";
    }

  private:
    void look(bool is_row);
    void advance();
    std::size_t next_stop() const;
    void store();
    void clean_up();
    std::string place() const {
        return fmt::format("step {} (t = {:.6g})", simulation_.plane().steps(),
                           simulation_.plane().time());
    }

    PlaneSimulation simulation_;
    RunOptions options_;
    std::filesystem::path checkpoint_;
    std::optional<RunLock> lock_{};
    std::optional<PlaneFiles> files_{};
    Highlights highlights_{};
    struct End {
        Highlights highlights;
        std::vector<Journal::Mark> journals;
    };
    std::optional<End> end_{};  // without the last row, where a run with a later end has none
    bool is_stored_ = false;    // whether the checkpoint is one of this run
};

void PlaneRun::to_the_end() {
    try {
        advance();
    } catch (const Unstable&) {
        files_->publish(simulation_, false);  // the energies up to there
        clean_up();
        throw;
    }
    try {
        files_->publish(simulation_, true);
    } catch (const FileError&) {  // where the disk does not take the files, it may take this
        store();
        throw;
    }
    if (options_.keep_checkpoint) {
        store();
    } else {
        clean_up();
    }
}

void PlaneRun::store() {
    files_->sync();
    const End end = end_ ? *end_ : End{highlights_, files_->marks()};
    std::vector<std::vector<double>> state = simulation_.state();
    state.push_back({end.highlights.peak, end.highlights.driven_peak, end.highlights.drift});
    save_checkpoint(checkpoint_, {identity(simulation_), simulation_.plane().steps(),
                                  std::move(state), end.journals});
    files_->keep(true);
    files_->remove_leftovers();
    is_stored_ = true;
}

void PlaneRun::clean_up() {
    files_->keep(false);
    std::error_code ignored;
    std::filesystem::remove(checkpoint_, ignored);
    files_->remove_leftovers();
}

/// After its sources nothing feeds the body: an energy that grows tenfold from there is as unstable
/// as one that is not finite, unless it comes in from layers beside the scene's nodes.
void PlaneRun::look(bool is_row) {
    const nmbc::Plane& plane = simulation_.plane();
    const nmbc::PlaneEnergies energies = simulation_.energies();
    const double total = energies.total();
    const auto unstable = [&](const std::string& what) {
        return Unstable(fmt::format("{} at {}. Energies up to there: {}", what, place(),
                                    files_->energies().string()));
    };
    if (!std::isfinite(total)) {
        throw unstable("the energy is not finite");
    }
    const double between = double(look_every) * simulation_.plan().time_step;
    auto& [peak, driven_peak, drift] = highlights_;
    peak = std::max(peak, total);
    // Of a part of the plane, bonds of weights below 0 may make it a little less than 0.
    constexpr double little = 0.1;
    if (total < -little * peak) {
        throw unstable(fmt::format("the energy is below 0, {:.3g} of its peak,", total / peak));
    }
    if (plane.steps() == 0 || simulation_.is_driven(std::max(0.0, plane.time() - between))) {
        driven_peak = std::max(driven_peak, total);
    } else if (driven_peak > 0 && total > 10 * driven_peak &&
               std::abs(simulation_.times_supplied()) > 10) {
        const PlaneScene& scene = simulation_.scene();
        throw unstable(fmt::format("the energy has grown to {:.3g} times {},", total / driven_peak,
                                   scene.force || scene.drive || !scene.loads.empty()
                                       ? "its peak before its sources ended"
                                       : "what it was at the start"));
    }
    if (is_row) {
        const PlaneBalance balance = simulation_.balance();
        drift = std::max(drift, std::abs(balance.drift));
        files_->record(simulation_, energies, balance);
    }
}

/// The next step at which anything is written or looked at.
std::size_t PlaneRun::next_stop() const {
    const PlaneScene& scene = simulation_.scene();
    const std::size_t now = simulation_.plane().steps();
    std::size_t stop = simulation_.plan().steps;
    for (const std::size_t every : {look_every, scene.every, scene.snapshots}) {
        if (every > 0) {
            stop = std::min(stop, (now / every + 1) * every);
        }
    }
    return stop;
}

void PlaneRun::advance() {
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::duration<double>;
    const PlaneScene& scene = simulation_.scene();
    const std::size_t steps = simulation_.plan().steps;
    Progress progress(steps, options_.quiet, simulation_.plane().steps());
    auto flushed = Clock::now();
    auto stored = flushed;
    if (simulation_.plane().steps() == 0) {
        look(true);
        if (scene.snapshots > 0) {
            files_->take_snapshot(simulation_);
        }
    }
    while (!simulation_.is_done()) {
        const std::size_t stop = next_stop();
        simulation_.advance(stop - simulation_.plane().steps());
        const bool is_row = stop % scene.every == 0;
        if (stop % look_every == 0 || is_row) {
            look(is_row);
        }
        if (scene.snapshots > 0 && stop % scene.snapshots == 0) {
            files_->take_snapshot(simulation_);
        }
        progress.update(stop);
        if (simulation_.is_done()) {
            break;
        }
        if (interrupted()) {
            store();
            files_->publish(simulation_, false);
            throw Interrupted(
                fmt::format("stopped at {} of {}. Energies up to there: {}. --resume goes on",
                            place(), steps, files_->energies().string()));
        }
        const auto now = Clock::now();
        if (now - flushed > Seconds(1)) {
            files_->flush();
            flushed = now;
        }
        if (now - stored > Seconds(scene.checkpoint)) {
            store();
            stored = Clock::now();
        }
    }
    if (steps % scene.every != 0) {
        end_ = {highlights_, files_->marks()};
        look(true);
    }
}

void PlaneRun::print() const {
    const double peak = highlights_.peak;
    if (peak == 0) {
        throw Unstable(fmt::format(
            "nothing moved at any time: no source acts before time.end, or they cancel. "
            "Energies: {}",
            files_->energies().string()));
    }
    constexpr std::size_t printed = 12;
    const std::vector<std::vector<double>> rows = files_->rows(printed);
    if (!options_.quiet) {
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
    if (rows.back()[4] > 10 * least && !simulation_.is_driven(simulation_.plane().time()) &&
        std::ranges::any_of(simulation_.scene().sides,
                            [](const PlaneSideChoice& side) { return may_grow(side.kind); })) {
        fmt::print(stderr,
                   "nmbcrun: warning: the energy has grown to {:.2g} times the least of the table: "
                   "its sides feed it\n",
                   rows.back()[4] / least);
    }
    const PlaneBalance balance = simulation_.balance();
    fmt::print("energy left  {:.3e} of the peak\n", rows.back()[4] / peak);
    if (std::isfinite(balance.drift)) {
        fmt::print("went out     {:.3e} left, {:.3e} right, {:.3e} bottom, {:.3e} top\n",
                   balance.left[0] / peak, balance.left[1] / peak, balance.left[2] / peak,
                   balance.left[3] / peak);
        fmt::print("ledger drift {:.1e} of the peak\n", highlights_.drift / peak);
    }
    if (simulation_.scene().fracture) {
        fmt::print("{}", crack_report(simulation_, *files_));
    }
    fmt::print("{}", files_->listed());
}

}  // namespace

void run_plane(const PlaneScene& scene, const RunOptions& options) {
    PlaneRun run(scene, options);
    print_warning(run.simulation());
    if (!options.quiet) {
        const PlanePlan& plan = run.simulation().plan();
        fmt::print("{}time      {} steps of {}\n\n", heading_of(run.simulation()), plan.steps,
                   heading_of(plan));
    }
    try {
        run.to_the_end();
    } catch (const FileError& error) {
        throw FileError(fmt::format("{}. {}", error.what(), run.what_is_kept()));
    }
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
    if (scene.snapshots > 0 && !is_drawn) {
        fmt::print("no picture   of the snapshots: their format is not \"vtk\"\n");
    } else if (scene.snapshots > 0) {
        draw("fields.gp", {file("_fields"), file(".pvd"), scene.title},
             {file("_fields.png"), file("_fields.gif")});
    }
}

}  // namespace nmbcrun
