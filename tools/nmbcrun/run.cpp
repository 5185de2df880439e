// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "tools/nmbcrun/output/checkpoint.hpp"
#include "tools/nmbcrun/output/checksum.hpp"
#include "tools/nmbcrun/output/interrupt.hpp"
#include "tools/nmbcrun/output/progress.hpp"
#include "tools/nmbcrun/output/recorder.hpp"
#include "tools/nmbcrun/report.hpp"
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

/// All that a run with these keys and plan goes on from must have in common, the name of a key
/// each; what changes no result is left out.
std::map<std::string, std::string> identity(const Simulation& simulation) {
    auto keys = simulation.scene().given;
    keys.erase("title");
    keys.erase("output.checkpoint");
    for (const auto& file : simulation.scene().own_tables) {
        keys["the checksum of " + file->name()] = fmt::format("{:x}", checksum(file->text()));
    }
    keys["the version of nmbcrun"] = NMBC_VERSION;
    keys["the time step"] = fmt::format("{:a}", simulation.plan().time_step);
    keys["the number of steps"] = fmt::format("{}", simulation.plan().steps);
    return keys;
}

void require_same(const std::map<std::string, std::string>& stored,
                  const std::map<std::string, std::string>& given,
                  const std::filesystem::path& checkpoint) {
    const auto value = [](const auto& keys, const std::string& key) {
        const auto found = keys.find(key);
        return found == keys.end() ? std::string("not given") : found->second;
    };
    auto all = stored;
    all.insert(given.begin(), given.end());
    for (const auto& [key, unused] : all) {
        if (value(stored, key) != value(given, key)) {
            throw SceneError(fmt::format("{} is of another scene: there {} is {}, here {}",
                                         checkpoint.string(), key, value(stored, key),
                                         value(given, key)));
        }
    }
}

/// One run, from its start or from a checkpoint, to its end.
class Run {
  public:
    Run(const Scene& scene, const RunOptions& options)
        : simulation_(scene),
          ledger_(simulation_.make_ledger()),
          quiet_(options.quiet),
          checkpoint_(options.folder / (scene.name + ".checkpoint")) {
        require_replaceable(checkpoint_);
        if (options.resume) {
            const Checkpoint from = load_checkpoint(checkpoint_);
            require_same(from.scene, identity(simulation_), checkpoint_);
            recorder_.emplace(scene, options.folder, from.journals);
            simulation_.resume(from.chain);
            ledger_.resume(simulation_.chain(), from.ledger);
            highlights_ = from.highlights;
            is_stored_ = true;
        } else {
            recorder_.emplace(scene, simulation_.chain(), options.folder);
            highlights_.driven_peak = simulation_.energies().total();
            highlights_.peak = highlights_.driven_peak;
        }
    }

    void to_the_end();
    std::string what_is_kept() const;
    void print() const;

    const Simulation& simulation() const { return simulation_; }

  private:
    const nmbc::Chain& chain() const { return simulation_.chain(); }
    std::size_t next_stop() const;
    void step();
    void look_at(const Sample& sample);
    void keep_for_report(const Sample& sample);
    void advance();
    void store();
    void publish_end();
    void clean_up();
    std::string place() const;
    Unstable unstable(const std::string& what) const;

    Simulation simulation_;
    Ledger ledger_;
    std::optional<Recorder> recorder_;
    Highlights highlights_;
    bool quiet_;
    std::filesystem::path checkpoint_;
    bool is_stored_ = false;  // whether the checkpoint is one of this run
};

std::string Run::place() const {
    return fmt::format("step {} (t = {:.6g})", chain().steps(), chain().time());
}

Unstable Run::unstable(const std::string& what) const {
    return Unstable(fmt::format("{} at {}: {}. Energies up to there: {}", what, place(),
                                likely_cause(simulation_.plan()), recorder_->energies().string()));
}

/// After its sources nothing feeds the chain any more: an energy that grows tenfold from there is
/// as unstable as one that is not finite. Those overflow long before the fields do.
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
    if (simulation_.is_driven(chain().time())) {
        driven_peak = std::max(driven_peak, total);
    } else if (driven_peak > 0 && total > 10 * driven_peak) {
        throw unstable(fmt::format(
            "the energy has grown to {:.3g} times its peak before its sources ended, most "
            "at {},",
            total / driven_peak, fastest_node(chain())));
    }
}

/// About twelve of a run's rows, and the last.
void Run::keep_for_report(const Sample& sample) {
    const std::size_t every = simulation_.scene().every;
    const std::size_t rows = (simulation_.plan().steps + every - 1) / every;
    const std::size_t row = (chain().steps() + every - 1) / every - 1;
    if (row % std::max<std::size_t>(1, rows / 12) == 0 || simulation_.is_done()) {
        highlights_.samples.push_back(sample);
    }
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
    const std::size_t steps = chain().steps();
    const bool is_row = steps % simulation_.scene().every == 0 || simulation_.is_done();
    if (is_row || steps % look_every == 0) {
        const auto energies = simulation_.energies();
        const Sample sample{chain().time() - simulation_.plan().time_step / 2, energies,
                            ledger_.balance(chain(), energies)};
        if (is_row && std::isfinite(energies.total())) {
            keep_for_report(sample);
            recorder_->record(sample, chain());
        }
        look_at(sample);
    }
    recorder_->look(chain());
}

void Run::store() {
    save_checkpoint(checkpoint_, {identity(simulation_), chain().state(), ledger_.totals(),
                                  highlights_, recorder_->marks()});
    recorder_->keep(true);
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
    clean_up();
}

void Run::clean_up() {
    recorder_->keep(false);
    remove_checkpoint(checkpoint_);
}

void Run::advance() {
    using Clock = std::chrono::steady_clock;
    const std::chrono::duration<double> pause(simulation_.scene().checkpoint);
    Progress progress(simulation_.plan().steps, quiet_, chain().steps());
    auto stored = Clock::now();
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
        if (chain().steps() % look_every == 0 && Clock::now() - stored > pause) {
            store();
            stored = Clock::now();
        }
    }
}

void Run::print() const {
    const Scene& scene = simulation_.scene();
    if (highlights_.peak == 0) {
        throw Unstable(fmt::format(
            "there was no energy at any time, so nothing to compare with: {}. Energies: {}",
            simulation_.why_no_energy(), recorder_->energies().string()));
    }
    if (!quiet_) {
        print_samples(highlights_, is_damped(scene));
    }
    print_balance(highlights_, is_damped(scene));
    fmt::print("{}", recorder_->files());
}

}  // namespace

void run(const Scene& scene, const RunOptions& options) {
    Run run(scene, options);
    if (!run.simulation().plan().objection.empty()) {
        fmt::print(stderr, "nmbcrun: warning: {}\n", run.simulation().plan().objection);
    }
    if (!run.simulation().warning().empty()) {
        fmt::print(stderr, "nmbcrun: warning: {}\n", printable(run.simulation().warning()));
    }
    if (!options.quiet) {
        print_heading(run.simulation());
    }
    try {
        run.to_the_end();
    } catch (const FileError& error) {
        throw FileError(fmt::format("{}. {}", error.what(), run.what_is_kept()));
    }
    run.print();
}

}  // namespace nmbcrun
