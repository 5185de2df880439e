// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "tools/nmbcrun/certification/time_step.hpp"
#include "tools/nmbcrun/compare/prospect.hpp"
#include "tools/nmbcrun/output/checkpoint.hpp"
#include "tools/nmbcrun/output/interrupt.hpp"
#include "tools/nmbcrun/output/progress.hpp"
#include "tools/nmbcrun/output/recorder.hpp"
#include "tools/nmbcrun/output/run_lock.hpp"
#include "tools/nmbcrun/report.hpp"
#include "tools/nmbcrun/resumable.hpp"
#include "tools/nmbcrun/scene/printable.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"

namespace nmbcrun {
namespace {

constexpr std::size_t look_every = 10;  // steps; whatever is written, the peak is the same

std::string likely_cause(const Plan& plan) {
    return plan.objection.empty() ? "its ends are stable; an amplitude may be too large for doubles"
                                  : "these ends are not stable together, see the warning";
}

std::string name_of(std::size_t node, const nmbc::Chain& chain) {
    return fmt::format("node {} of {} (ghosts and layers counted, from 0)", node, chain.nodes());
}

/// The node with the largest velocity, where an instability shows most.
std::string fastest_node(const nmbc::Chain& chain) {
    const auto fastest =
        std::ranges::max_element(chain.velocity(), {}, [](double v) { return std::abs(v); });
    return name_of(std::size_t(fastest - chain.velocity().begin()), chain);
}

/// One run, from its start or from a checkpoint, to its end.
class Run {
  public:
    Run(const Scene& scene, const RunOptions& options)
        : simulation_(scene),
          prospect_(prospect_of(simulation_)),
          ledger_(simulation_.make_ledger()),
          options_(options),
          checkpoint_(options.folder / (scene.name + ".checkpoint")) {
        if (!prospect_.objection.empty() && !scene.allow_amplifying && !scene.allow_unstable) {
            throw Unstable(
                fmt::format("{}. {}{}. To run it all the same: boundary.allow_amplifying = true",
                            prospect_.objection,
                            prospect_.warnings.empty()
                                ? "Another model.G, order or stride may absorb it: nmbcrun advise"
                                : fmt::format("{}", fmt::join(prospect_.warnings, ". ")),
                            choices_at_another_G(scene)));
        }
        note_interrupts();  // up to here nothing was written
        nmbcgen::require_replaceable(checkpoint_);
        lock_.emplace(options.folder / (scene.name + ".lock"));
        if (options.resume) {
            const Checkpoint from = load_checkpoint(checkpoint_);
            require_resumable(identity(simulation_), simulation_.plan().steps, from, checkpoint_);
            const ChainRun stored = chain_run_of(from, checkpoint_);
            recorder_.emplace(scene, options.folder, from.journals);
            simulation_.resume(stored.chain);
            ledger_.resume(simulation_.chain(), stored.ledger);
            highlights_ = stored.highlights;
            is_stored_ = true;
        } else {
            replaces_earlier_ = std::filesystem::exists(checkpoint_);
            recorder_.emplace(
                scene, simulation_.chain(), options.folder,
                fmt::format("nmbcrun   {}\n{}step      {}\nunits     those of the scene, any "
                            "consistent system; energies per cross-section area\n",
                            NMBC_VERSION, heading_of(simulation_), heading_of(simulation_.plan())));
            highlights_.driven_peak = simulation_.energies().total();
            highlights_.peak = highlights_.driven_peak;
        }
    }

    void to_the_end();
    std::string what_is_kept() const;
    void print() const;

    const Simulation& simulation() const { return simulation_; }
    const Prospect& prospect() const { return prospect_; }

    /// What the user may not expect of this run, each in one line.
    std::vector<std::string> warnings() const;

  private:
    /// What a run with a later end goes on from, without the last row where that run has none.
    struct End {
        Highlights highlights;
        std::vector<Journal::Mark> journals;
    };

    const nmbc::Chain& chain() const { return simulation_.chain(); }
    std::size_t next_stop() const;
    void step();
    void look_at(const Sample& sample);
    Sample sample() const;
    void add_last_row();
    void advance();
    void store();
    void publish_end();
    void clean_up();
    std::string place() const;
    Unstable unstable(const std::string& what) const;

    Simulation simulation_;
    Prospect prospect_;
    Ledger ledger_;
    std::optional<RunLock> lock_;
    std::optional<Recorder> recorder_;
    Highlights highlights_;
    RunOptions options_;
    std::filesystem::path checkpoint_;
    std::optional<End> end_;
    bool is_stored_ = false;         // whether the checkpoint is one of this run
    bool replaces_earlier_ = false;  // whether it is of one that cannot go on then
};

std::string Run::place() const {
    return fmt::format("step {} (t = {:.6g})", chain().steps(), chain().time());
}

Unstable Run::unstable(const std::string& what) const {
    return Unstable(fmt::format("{} at {}: {}. Energies up to there: {}", what, place(),
                                likely_cause(simulation_.plan()), recorder_->energies().string()));
}

/// After its sources nothing feeds the chain any more: an energy that grows tenfold from there is
/// as unstable as one that is not finite. Those overflow long before the fields do. What a source
/// gave since the last look is in this sample alone, so that this one counts as driven.
void Run::look_at(const Sample& sample) {
    const double total = sample.energies.total();
    if (!std::isfinite(total) || (simulation_.is_done() && !chain().is_finite())) {
        throw unstable(chain().is_finite()
                           ? fmt::format("the energy of {} is not finite", fastest_node(chain()))
                           : name_of(chain().first_not_finite(), chain()) + " is not finite");
    }
    highlights_.peak = std::max(highlights_.peak, total);
    highlights_.drift = std::max(highlights_.drift, std::abs(sample.balance.drift));
    double& driven_peak = highlights_.driven_peak;
    const double between = double(look_every) * simulation_.plan().time_step;
    if (simulation_.is_driven(std::max(0.0, chain().time() - between))) {
        driven_peak = std::max(driven_peak, total);
    } else if (driven_peak > 0 && total > 10 * driven_peak) {
        throw unstable(fmt::format(
            "the energy has grown to {:.3g} times its peak before its sources ended, most "
            "at {},",
            total / driven_peak, fastest_node(chain())));
    }
}

Sample Run::sample() const {
    const auto energies = simulation_.energies();
    return {chain().time() - simulation_.plan().time_step / 2, energies,
            ledger_.balance(chain(), energies)};
}

/// The next step at which anything is written or looked at.
std::size_t Run::next_stop() const {
    const Scene& scene = simulation_.scene();
    std::size_t stop = simulation_.plan().steps;
    for (const std::size_t every : {look_every, scene.every, scene.snapshots}) {
        if (every > 0) {
            stop = std::min(stop, (chain().steps() / every + 1) * every);
        }
    }
    return stop;
}

/// On to the next stop. Many steps at once are faster than one by one, and the same bit for bit.
void Run::step() {
    simulation_.advance(next_stop() - chain().steps(), ledger_);
    const bool is_row = chain().steps() % simulation_.scene().every == 0;
    if (is_row || chain().steps() % look_every == 0) {
        const Sample now = sample();
        if (is_row && std::isfinite(now.energies.total())) {
            recorder_->record(now, chain());
        }
        look_at(now);
    }
    recorder_->look(chain());
}

/// Of the last step, where no row is due.
void Run::add_last_row() {
    if (chain().steps() % simulation_.scene().every == 0) {
        return;
    }
    end_ = {highlights_, recorder_->marks()};
    const Sample last = sample();
    if (std::isfinite(last.energies.total())) {
        recorder_->record(last, chain());
    }
    look_at(last);
}

void Run::store() {
    recorder_->sync();
    const End& end = end_ ? *end_ : End{highlights_, recorder_->marks()};
    save_checkpoint(checkpoint_,
                    {identity(simulation_), chain().steps(),
                     packed({chain().state(), ledger_.totals(), end.highlights}), end.journals});
    recorder_->keep(true);
    recorder_->remove_leftovers();
    is_stored_ = true;
}

/// Where the disk does not take the files, it may take a checkpoint.
void Run::publish_end() {
    try {
        recorder_->publish(chain(), true);
    } catch (const FileError&) {
        store();
        throw;
    }
}

std::vector<std::string> Run::warnings() const {
    std::vector<std::string> all{simulation_.plan().objection, simulation_.warning()};
    std::erase(all, "");
    all.insert(all.end(), prospect_.warnings.begin(), prospect_.warnings.end());
    if (replaces_earlier_) {
        all.push_back(
            fmt::format("{} is of an earlier run, which --resume would have gone on with; "
                        "this run removes it when it ends",
                        checkpoint_.string()));
    }
    return all;
}

std::string Run::what_is_kept() const {
    return is_stored_ ? fmt::format("--resume goes on from {}", checkpoint_.string())
                      : "no checkpoint was stored, nothing is kept of this run";
}

void Run::to_the_end() {
    try {
        advance();
        publish_end();
    } catch (const Unstable&) {
        recorder_->publish(chain(), false);  // the energies up to there
        clean_up();
        throw;
    }
    if (options_.keep_checkpoint) {
        store();
    } else {
        clean_up();
    }
}

void Run::clean_up() {
    recorder_->keep(false);
    std::error_code ignored;
    std::filesystem::remove(checkpoint_, ignored);
    recorder_->remove_leftovers();
}

void Run::advance() {
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::duration<double>;
    const Seconds pause(simulation_.scene().checkpoint);
    constexpr Seconds until_flushed(1);
    Progress progress(simulation_.plan().steps, options_.quiet, chain().steps());
    auto stored = Clock::now();
    auto flushed = stored;
    while (!simulation_.is_done()) {
        step();
        progress.update(chain().steps());
        if (simulation_.is_done()) {
            break;
        }
        if (interrupted()) {
            store();
            recorder_->publish(chain(), false);
            throw Interrupted(
                fmt::format("stopped at {} of {}. Energies up to there: {}. --resume goes on",
                            place(), simulation_.plan().steps, recorder_->energies().string()));
        }
        const auto now = Clock::now();
        if (now - flushed > until_flushed) {
            recorder_->flush();
            flushed = now;
        }
        if (now - stored > pause) {
            store();
            stored = Clock::now();
        }
    }
    add_last_row();
}

void Run::print() const {
    const Scene& scene = simulation_.scene();
    if (highlights_.peak == 0) {
        throw Unstable(fmt::format(
            "there was no energy at any time, so nothing to compare with: {}. Energies: {}",
            simulation_.why_no_energy(), recorder_->energies().string()));
    }
    const std::size_t rows = (simulation_.plan().steps + scene.every - 1) / scene.every;
    const auto samples = recorder_->samples(rows);
    if (!options_.quiet) {
        print_samples(samples, highlights_.peak, is_damped(scene));
    }
    print_balance(samples.back(), highlights_, is_damped(scene));
    fmt::print("{}", recorder_->files());
}

}  // namespace

void run(const Scene& scene, const RunOptions& options) {
    Run run(scene, options);
    for (const std::string& warning : run.warnings()) {
        fmt::print(stderr, "nmbcrun: warning: {}\n", printable(warning));
    }
    if (!options.quiet) {
        const Plan& plan = run.simulation().plan();
        const std::string& ends = run.prospect().ends;
        fmt::print("{}{}time      {} steps of {}\n\n", heading_of(run.simulation()),
                   ends.empty() ? "" : fmt::format("ends      {}\n", ends), plan.steps,
                   heading_of(plan));
    }
    try {
        run.to_the_end();
    } catch (const FileError& error) {
        throw FileError(fmt::format("{}. {}", error.what(), run.what_is_kept()));
    }
    run.print();
}

}  // namespace nmbcrun
