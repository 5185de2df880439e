// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/stoppable_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <system_error>
#include <utility>

#include "tools/nmbcrun/output/warnings.hpp"
#include "tools/nmbcrun/terminal/interrupt.hpp"
#include "tools/nmbcrun/terminal/progress.hpp"

namespace nmbcrun {

StoppableRun::StoppableRun(const AnyScene& scene, const RunOptions& options)
    : every_(scene.every),
      snapshots_(scene.snapshots),
      unit_of_time_(unit_of_time(scene)),
      pause_(scene.checkpoint),
      options_(options),
      name_(scene.name),
      checkpoint_(options.folder / (scene.name + ".checkpoint")) {}

std::optional<Checkpoint> StoppableRun::claim(std::map<std::string, std::string> identity,
                                              const StepPlan& plan) {
    identity_ = std::move(identity);
    plan_ = plan;
    note_interrupts();  // up to here nothing was written
    nmbcgen::require_replaceable(checkpoint_);
    lock_.emplace(options_.folder / (name_ + ".lock"));
    if (!options_.resume) {
        replaces_earlier_ = std::filesystem::exists(checkpoint_);
        return std::nullopt;
    }
    Checkpoint from = load_checkpoint(checkpoint_);
    require_resumable(identity_, plan_.steps, from, checkpoint_);
    if (from.state.empty() || from.state.back().size() != 3) {
        throw FileError(fmt::format("{} is no checkpoint of a run", checkpoint_.string()));
    }
    highlights_ = {from.state.back()[0], from.state.back()[1], from.state.back()[2]};
    from.state.pop_back();
    is_stored_ = true;
    return from;
}

StepsLeft StoppableRun::steps_left(const RunSize& size) const {
    return {plan_.steps - steps(), size.nodes, size.pace};
}

Output StoppableRun::output_of(const RunSize& size) const {
    const auto left = double(steps_left(size).steps);
    const auto every = [&](std::size_t interval) {
        return interval == 0 ? 0.0 : left / double(interval);
    };
    return {every(every_), double(size.probes), every(snapshots_), size.bytes_of_snapshot,
            size.bytes_at_end};
}

double StoppableRun::free_bytes() const {
    std::error_code unknown;  // then as much as one likes is free
    const auto space = std::filesystem::space(options_.folder, unknown);
    return unknown || space.capacity == 0 ? HUGE_VAL : double(space.available);
}

void StoppableRun::require_possible(const RunSize& size) const {
    require_bearable_length(plan_, unit_of_time_, steps_left(size));
    require_space(output_of(size), free_bytes());
}

void StoppableRun::warn(std::vector<std::string> warnings, const RunSize& size) const {
    warnings.push_back(warning_of_files(output_of(size), free_bytes()));
    std::erase(warnings, "");
    for (const std::string& one : warnings_of_steps(plan_, unit_of_time_, steps_left(size))) {
        warnings.push_back(one);
    }
    if (replaces_earlier_) {
        warnings.push_back(
            fmt::format("{} is of an earlier run, which --resume would have gone on with; "
                        "this run removes it when it ends",
                        checkpoint_.string()));
    }
    print_warnings(warnings);
}

std::string StoppableRun::place() const {
    return fmt::format("step {} (t = {:.6g})", steps(), time());
}

bool StoppableRun::has_grown(double energy, bool is_driven) {
    auto& [peak, driven_peak, drift] = highlights_;
    peak = std::max(peak, energy);
    if (is_driven) {
        driven_peak = std::max(driven_peak, energy);
        return false;
    }
    return has_grown_since_driven(energy);
}

bool StoppableRun::has_grown_since_driven(double energy) const {
    return highlights_.driven_peak > 0 && energy > 10 * highlights_.driven_peak;
}

std::string StoppableRun::growth(double energy, bool has_sources) const {
    return fmt::format(
        "the energy has grown to {:.3g} times {}", energy / highlights_.driven_peak,
        has_sources ? "the peak that it had while its sources acted" : "what it was at the start");
}

/// The next step at which anything is written or looked at.
std::size_t StoppableRun::next_stop() const {
    std::size_t stop = plan_.steps;
    for (const std::size_t every : {look_every, every_, snapshots_}) {
        if (every > 0) {
            stop = std::min(stop, (steps() / every + 1) * every);
        }
    }
    return stop;
}

/// On to the next stop. Many steps at once are faster than one by one, and the same bit for bit.
void StoppableRun::step() {
    advance(next_stop() - steps());
    const bool is_row = steps() % every_ == 0;
    if (is_row || steps() % look_every == 0) {
        look(is_row);
    }
    if (snapshots_ > 0 && steps() % snapshots_ == 0) {
        take_snapshot();
    }
}

/// Of the last step, where no row is due.
void StoppableRun::add_last_row() {
    if (steps() % every_ == 0) {
        return;
    }
    end_ = {highlights_, files().marks()};
    look(true);
}

void StoppableRun::store() {
    files().sync();
    const auto& [highlights, journals] = end_ ? *end_ : End{highlights_, files().marks()};
    std::vector<std::vector<double>> all = state();
    all.push_back({highlights.peak, highlights.driven_peak, highlights.drift});
    save_checkpoint(checkpoint_, {identity_, steps(), std::move(all), journals});
    files().keep(true);
    is_stored_ = true;
    files().remove_leftovers();
}

void StoppableRun::clean_up() {
    files().keep(false);
    std::error_code ignored;
    std::filesystem::remove(checkpoint_, ignored);
    files().remove_leftovers();
}

void StoppableRun::stop() {
    store();
    publish(false);
    throw Interrupted(fmt::format("stopped at {} of {}. Energies up to there: {}. --resume goes on",
                                  place(), plan_.steps, files().energies().string()));
}

void StoppableRun::go_on() {
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::duration<double>;
    constexpr Seconds until_flushed(1);
    Progress progress(plan_.steps, options_.quiet, steps());
    auto flushed = Clock::now();
    auto stored = flushed;
    if (steps() == 0) {
        begin();
        if (snapshots_ > 0) {
            take_snapshot();
        }
    }
    while (!is_done()) {
        step();
        progress.update(steps());
        if (is_done()) {
            break;
        }
        if (interrupted()) {
            stop();
        }
        const auto now = Clock::now();
        if (now - flushed > until_flushed) {
            files().flush();
            flushed = now;
        }
        if (now - stored > Seconds(pause_)) {
            store();
            stored = Clock::now();
        }
    }
    add_last_row();
}

/// Where the disk does not take the files, it may take a checkpoint. Why not is what the user is
/// told, not what came of the checkpoint.
void StoppableRun::publish_end() {
    try {
        publish(true);
    } catch (const FileError&) {
        try {
            store();
        } catch (const FileError&) {  // is_stored_ tells
        }
        throw;
    }
}

/// Publishes the energies up to there.
void StoppableRun::end_unstable(const Unstable& unstable) {
    std::string unwritten;
    try {
        publish(false);
    } catch (const FileError& error) {
        unwritten = fmt::format(". The energies up to there are lost: {}", error.what());
    }
    clean_up();
    throw Unstable(unstable.what() + unwritten);
}

void StoppableRun::go_on_and_publish() {
    try {
        go_on();
        publish_end();
    } catch (const Unstable& unstable) {
        end_unstable(unstable);
    }
    if (options_.keep_checkpoint) {
        store();
    } else {
        clean_up();
    }
}

void StoppableRun::to_the_end() {
    try {
        go_on_and_publish();
    } catch (const FileError& error) {
        throw FileError(
            fmt::format("{}. {}", error.what(),
                        is_stored_ ? fmt::format("--resume goes on from {}", checkpoint_.string())
                                   : "No checkpoint was stored, nothing is kept of this run"));
    }
}

}  // namespace nmbcrun
