// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <optional>
#include <utility>

#include "generator/names/printable.hpp"
#include "tools/nmbcrun/certification/stand_ins.hpp"
#include "tools/nmbcrun/output/chain_files.hpp"
#include "tools/nmbcrun/output/energies_file.hpp"
#include "tools/nmbcrun/output/step_warnings.hpp"
#include "tools/nmbcrun/output/stoppable_run.hpp"
#include "tools/nmbcrun/prediction/prospect.hpp"
#include "tools/nmbcrun/report.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun {
namespace {

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

/// Whether a run that ends later takes other steps up to there, too.
bool depends_on_end(const Scene& scene) {
    const auto depends = [](const Boundary& boundary) {
        return boundary.kind == BoundaryKind::exact ||
               (boundary.kind == BoundaryKind::extended && boundary.layer == 0);
    };
    return scene.incoming || depends(scene.left) || depends(scene.right);
}

class Run : public StoppableRun {
  public:
    Run(const Scene& scene, const RunOptions& options);

    void print();

    const Simulation& simulation() const { return simulation_; }
    const Prospect& prospect() const { return prospect_; }
    const std::string& heading() const { return heading_; }

    /// What the user may not expect of this run, each in one line.
    std::vector<std::string> warnings() const;

  private:
    const nmbc::Chain& chain() const { return simulation_.chain(); }

    std::size_t steps() const override { return chain().steps(); }
    double time() const override { return chain().time(); }
    void advance(std::size_t steps) override { simulation_.advance(steps, ledger_); }
    std::vector<std::vector<double>> state() const override;
    void begin() override { has_grown(simulation_.energies().total(), true); }
    void look(bool is_row) override;
    void take_snapshot() override { files_->take_snapshot(chain()); }
    RunFiles& files() override { return *files_; }
    void publish(bool at_end) override { files_->publish(chain(), at_end); }

    void go_on_from(const Checkpoint& checkpoint);
    void judge(const Sample& sample);
    Unstable unstable(const std::string& what);

    Simulation simulation_;
    Prospect prospect_;
    std::string heading_;
    Ledger ledger_;
    std::optional<ChainFiles> files_{};
};

Run::Run(const Scene& scene, const RunOptions& options)
    : StoppableRun(scene, options),
      simulation_(scene),
      prospect_(prospect_of(simulation_)),
      heading_(heading_of(simulation_)),
      ledger_(simulation_.make_ledger()) {
    if (!prospect_.objection.empty() && !scene.allow_amplifying && !scene.allow_unstable) {
        std::vector<std::string> sentences{prospect_.objection};
        if (prospect_.warnings.empty()) {
            sentences.emplace_back(
                "Another model.G, order or stride may absorb it: nmbcrun advise");
        }
        std::ranges::copy(prospect_.warnings, std::back_inserter(sentences));
        sentences.push_back(choices_in_place(scene, [](Scene other) {
            other.step.reset();  // theirs may be shorter
            other.cfl.reset();
            return absorbs(other);
        }));
        std::erase(sentences, "");
        sentences.emplace_back("To run it all the same: boundary.allow_amplifying = true");
        throw Unstable(fmt::format("{}", fmt::join(sentences, ".\n")));
    }
    const Plan& plan = simulation_.plan();
    const auto from =
        claim(identity_of(scene, depends_on_end(scene), plan, inputs_of(scene)), plan);
    files_.emplace(scene, options.folder, about(heading_, plan, "cross-section area"),
                   from ? from->journals : std::vector<Journal::Mark>());
    if (from) {
        go_on_from(*from);
    }
}

std::vector<std::vector<double>> Run::state() const {
    nmbc::ChainState<double> chain = this->chain().state();
    const Ledger::Totals& ledger = ledger_.totals();
    return {std::move(chain.displacement), std::move(chain.velocity),
            std::move(chain.damped),       std::move(chain.left),
            std::move(chain.right),        {ledger.start, ledger.work, ledger.left, ledger.right}};
}

void Run::go_on_from(const Checkpoint& checkpoint) {
    const auto& parts = checkpoint.state;
    if (parts.size() != 6 || parts[5].size() != 4) {
        throw FileError(fmt::format("{} is no checkpoint of a chain", this->checkpoint().string()));
    }
    simulation_.resume({.steps = checkpoint.steps,
                        .displacement = parts[0],
                        .velocity = parts[1],
                        .damped = parts[2],
                        .left = parts[3],
                        .right = parts[4]});
    ledger_.resume(chain(), {parts[5][0], parts[5][1], parts[5][2], parts[5][3]});
}

Unstable Run::unstable(const std::string& what) {
    return Unstable(fmt::format("{} at {}: {}. Energies up to there: {}", what, place(),
                                likely_cause(simulation_.plan()), files_->energies().string()));
}

void Run::look(bool is_row) {
    const auto energies = simulation_.energies();
    const Sample now{time() - simulation_.plan().time_step / 2, energies,
                     ledger_.balance(chain(), energies)};
    if (is_row && std::isfinite(energies.total())) {
        files_->record(now, chain());
    }
    judge(now);
}

void Run::judge(const Sample& sample) {
    const double total = sample.energies.total();
    if (!std::isfinite(total) || (simulation_.is_done() && !chain().is_finite())) {
        throw unstable(chain().is_finite()
                           ? fmt::format("the energy of {} is not finite", fastest_node(chain()))
                           : name_of(chain().first_not_finite(), chain()) + " is not finite");
    }
    highlights().drift = std::max(highlights().drift, std::abs(sample.balance.drift));
    const double between = double(look_every) * simulation_.plan().time_step;
    // However stable, the total swings up to what leapfrog keeps over 1 - cfl^2.
    const double cfl = simulation_.plan().cfl;
    if (has_grown(total, simulation_.is_driven(std::max(0.0, time() - between))) &&
        (has_grown_since_driven(std::abs(sample.energies.staggered)) ||
         has_grown_since_driven((1 - cfl * cfl) * total))) {
        const Scene& scene = simulation_.scene();
        const bool has_sources =
            scene.force || scene.drive || scene.incoming || scene.left.value || scene.right.value;
        throw unstable(
            fmt::format("{}, most at {},", growth(total, has_sources), fastest_node(chain())));
    }
}

std::vector<std::string> Run::warnings() const {
    const Scene& scene = simulation_.scene();
    std::vector<std::string> all = simulation_.warnings();
    all.insert(all.begin(), {simulation_.plan().objection, warning_of_short_run(scene)});
    for (const Boundary* end : {&scene.left, &scene.right}) {
        if (end->kind == BoundaryKind::nmbc) {
            all.push_back(in_place_of_committed(scene, *end));
        }
    }
    std::erase(all, "");
    all.erase(std::unique(all.begin(), all.end()), all.end());  // of both ends
    if (prospect_.sends_much_back) {
        all.push_back("at the ends " + prospect_.ends + ": nmbcrun advise compares others");
    }
    all.insert(all.end(), prospect_.warnings.begin(), prospect_.warnings.end());
    return all;
}

void Run::print() {
    const Scene& scene = simulation_.scene();
    const double peak = highlights().peak;
    if (peak == 0) {
        throw Unstable(fmt::format(
            "there was no energy at any time, so nothing to compare with: {}. Energies: {}",
            simulation_.why_no_energy(), files_->energies().string()));
    }
    const std::size_t rows = (simulation_.plan().steps + scene.every - 1) / scene.every;
    std::vector<Sample> samples;
    for (const std::vector<double>& row : files_->rows(rows, printed_rows)) {
        samples.push_back(sample_of(row));
    }
    if (!options().quiet) {
        print_samples(samples, peak, is_damped(scene));
    }
    print_balance(samples.back(), highlights(), is_damped(scene));
    fmt::print("{}", nmbcgen::printable_lines(files_->listed()));
}

}  // namespace

void run(const Scene& scene, const RunOptions& options) {
    Run run(scene, options);
    // u and v, in a growing file and, at the end, its copy
    const double bytes_of_snapshot = 4.0 * sizeof(double) * double(scene.nodes);
    constexpr double bytes_of_line = 60;  // of x, u and v as text
    const RunSize size{run.simulation().chain().nodes(), chain_pace, bytes_of_snapshot,
                       2 * scene.probes.size(),
                       scene.field ? bytes_of_line * double(scene.nodes) : 0};
    run.require_possible(size);
    run.warn(run.warnings(), size);
    if (!options.quiet) {
        const Plan& plan = run.simulation().plan();
        const std::string& ends = run.prospect().ends;
        fmt::print("{}{}time      {} steps of {}{}\n\n", run.heading(),
                   ends.empty() ? "" : fmt::format("ends      {}\n", ends), plan.steps,
                   heading_of(plan), length_of_run(run.steps_left(size)));
        std::fflush(stdout);  // through a pipe, too, it is read before the run
    }
    run.to_the_end();
    run.print();
}

}  // namespace nmbcrun
