// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nmbc/chain.hpp>
#include <nmbc/energy.hpp>
#include <optional>

#include "tools/nmbcrun/output/csv.hpp"
#include "tools/nmbcrun/output/interrupt.hpp"
#include "tools/nmbcrun/output/progress.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"

namespace nmbcrun {
namespace {

struct Sample {
    double time;
    nmbc::Energies energies;
};

/// What was written of a run, and the largest total energy of every tenth step.
struct Record {
    std::vector<Sample> samples;
    double peak = 0;
};

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

/// Steps the chain to the end. After its sources nothing feeds the chain any more: an energy that
/// grows tenfold from there is as unstable as one that is not finite.
Record simulate(Simulation& simulation, CsvFile& csv, bool quiet) {
    const nmbc::Chain& chain = simulation.chain();
    const Plan& plan = simulation.plan();
    const std::size_t every = simulation.scene().every;
    Progress progress(plan.steps, quiet);
    Record record;
    double driven_peak = simulation.energies().total();
    record.peak = driven_peak;
    const auto unstable = [&](const std::string& what) {
        return Unstable(fmt::format("{} at step {} (t = {:.6g}): {}. Energies up to there: {}",
                                    what, chain.steps(), chain.time(), likely_cause(plan),
                                    csv.path().string()));
    };
    while (!simulation.is_done()) {
        simulation.step();
        progress.update(chain.steps());
        if (interrupted()) {
            throw Interrupted(
                fmt::format("stopped at step {} of {} (t = {:.6g}). Energies up to "
                            "there: {}",
                            chain.steps(), plan.steps, chain.time(), csv.path().string()));
        }
        if (!chain.is_finite()) {
            throw unstable(name_of(chain.first_not_finite(), chain) + " is not finite");
        }
        const bool to_be_written = chain.steps() % every == 0 || simulation.is_done();
        constexpr std::size_t look_every = 10;  // whatever is written, the peak is the same
        if (!to_be_written && chain.steps() % look_every != 0) {
            continue;
        }
        const double time = chain.time() - plan.time_step / 2;
        const nmbc::Energies energies = simulation.energies();
        if (to_be_written) {
            record.samples.push_back({time, energies});
            append_energies(csv, time, energies);
        }
        record.peak = std::max(record.peak, energies.total());
        const double total = energies.total();
        if (!std::isfinite(total)) {
            throw unstable(fmt::format("the energy of {} is not finite", fastest_node(chain)));
        }
        if (simulation.is_driven(chain.time())) {
            driven_peak = std::max(driven_peak, total);
        } else if (driven_peak > 0 && total > 10 * driven_peak) {
            throw unstable(
                fmt::format("the energy has grown to {:.3g} times its peak before its sources "
                            "ended, most at {},",
                            total / driven_peak, fastest_node(chain)));
        }
    }
    return record;
}

void print_heading(const Simulation& simulation) {
    const Scene& scene = simulation.scene();
    const Plan& plan = simulation.plan();
    fmt::print("scene     {}\n", scene.title);
    fmt::print("lattice   {} horizon {}, G = {}{}\n", scene.family, scene.horizon, scene.G,
               is_damped(scene) ? ", tau = " + scene.tau : "");
    if (scene.left == scene.right) {
        fmt::print("boundary  {}\n", heading_of(scene.left));
    } else {
        fmt::print("left      {}\n", heading_of(scene.left));
        fmt::print("right     {}\n", heading_of(scene.right));
    }
    fmt::print("chain     {} nodes, dX = {}, c = {:.6g}\n", scene.nodes, scene.spacing,
               simulation.chain().parameters().wave_speed());
    fmt::print("time      {} steps of {:.6g} (cfl = {:.3g}){}\n\n", plan.steps, plan.time_step,
               plan.cfl, plan.limit.empty() ? "" : ": " + plan.limit);
}

/// About twelve of the samples, and the last.
void print_samples(const std::vector<Sample>& samples, double peak, bool damped) {
    fmt::print("{:>10}  {:>12}  {:>12}  {:>14}  {:>12}  {:>10}{}\n", "time", "kinetic", "strain",
               "stabilisation", "total", "of peak", damped ? "        damped" : "");
    const std::size_t every = std::max<std::size_t>(1, samples.size() / 12);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (i % every != 0 && i + 1 != samples.size()) {
            continue;
        }
        const auto& [time, e] = samples[i];
        fmt::print("{:10.4g}  {:12.4e}  {:12.4e}  {:14.4e}  {:12.4e}  {:10.2e}{}\n", time,
                   e.kinetic, e.strain, e.stabilisation, e.total(), e.total() / peak,
                   damped ? fmt::format("  {:12.4e}", e.damped) : "");
    }
    fmt::print("\n");
}

}  // namespace

void run(const Scene& scene, const std::filesystem::path& folder, bool quiet) {
    Simulation simulation(scene);
    const nmbc::Chain& chain = simulation.chain();
    if (!simulation.plan().objection.empty()) {
        fmt::print(stderr, "nmbcrun: warning: {}\n", simulation.plan().objection);
    }
    CsvFile csv(folder / (scene.name + ".csv"), energies_header);
    std::optional<CsvFile> field;
    if (scene.field) {
        field.emplace(folder / (scene.name + "_field.csv"), field_header);
    }
    if (!quiet) {
        print_heading(simulation);
    }
    Record record;
    try {
        record = simulate(simulation, csv, quiet);
    } catch (const Unstable&) {
        csv.publish();  // the energies up to there
        throw;
    } catch (const Interrupted&) {
        csv.publish();
        throw;
    }
    csv.publish();
    if (field) {
        append_field(*field, chain);
        field->publish();
    }
    if (record.peak == 0) {
        throw Unstable(fmt::format(
            "there was no energy at any time, so nothing to compare with: {}. Energies: {}",
            simulation.why_no_energy(), csv.path().string()));
    }
    if (!quiet) {
        print_samples(record.samples, record.peak, is_damped(scene));
    }
    fmt::print("energy left  {:.3e} of the peak\nenergies     {}\n",
               record.samples.back().energies.total() / record.peak, csv.path().string());
    if (field) {
        fmt::print("field        {}\n", field->path().string());
    }
}

}  // namespace nmbcrun
