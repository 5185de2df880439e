// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nmbc/nmbc.hpp>
#include <optional>

#include "tools/nmbcrun/certificate.hpp"
#include "tools/nmbcrun/csv.hpp"
#include "tools/nmbcrun/driver.hpp"
#include "tools/nmbcrun/interrupt.hpp"
#include "tools/nmbcrun/progress.hpp"
#include "tools/nmbcrun/tables.hpp"
#include "tools/nmbcrun/time_step.hpp"

namespace nmbcrun {
namespace {

nmbc::ChainEnd end_of(const Scene& scene, const Boundary& boundary) {
    switch (boundary.kind) {
        case BoundaryKind::fixed:
            return nmbc::FixedEnd{};
        case BoundaryKind::free:
            return nmbc::FreeEnd{};
        default:
            return nmbc::MatchingEnd{// certify() decides, for the pair of ends.
                                     nmbc::boundary_coefficients(table_of(scene, boundary), scene.G,
                                                                 nmbc::allow_unstable),
                                     boundary.ghosts};
    }
}

/// Whether the ends are certified to be stable together; warns where they are not, but the scene
/// allows it. Throws Unstable where it does not.
bool certify(const Scene& scene, double time_step, double cfl) {
    const std::string problem =
        objection(scene, table_of(scene, scene.left), table_of(scene, scene.right), time_step, cfl);
    if (problem.empty()) {
        return true;
    }
    if (!scene.allow_unstable) {
        throw Unstable(
            problem +
            ". Try a smaller time step, another G, order or stride (windows: "
            "docs/stability.md), or run it all the same: boundary.allow_unstable = true");
    }
    fmt::print(stderr, "nmbcrun: warning: {}\n", problem);
    return false;
}

struct Sample {
    double time;
    nmbc::Energies energies;
};

/// What was written of a run, and the largest total energy of every tenth step.
struct Record {
    std::vector<Sample> samples;
    double peak = 0;
};

/// How long a run is, in steps, how its step compares with the interior's limit, what limits it,
/// and whether the ends are certified.
struct Plan {
    std::size_t steps = 0;
    double cfl = 0;
    std::string limit{};  ///< in words; empty where the scene gives the step
    bool certified = false;
};

std::string likely_cause(const Plan& plan) {
    if (!plan.certified) {
        return "these ends are not stable together, see the warning";
    }
    return "its ends are stable; drive.amplitude may be too large for doubles";
}

Plan plan_of(const Scene& scene, const nmbc::Lattice& lattice, double time_step, double omega_max) {
    const double cfl = time_step * omega_max / 2;
    const double limit = nmbc::interior_cfl(lattice);
    if (cfl > limit) {
        throw SceneError(fmt::format(
            "{}: cfl = {:.4g} is above the interior's limit of {:.4g}, a step of {:.6g}",
            scene.step ? "time.step" : "time.cfl", cfl, limit, 2 * limit / omega_max));
    }
    const double exact_steps = scene.end / time_step;
    if (exact_steps > 1e15) {
        throw SceneError(fmt::format("time.end asks for {:.3g} steps; at most 1e15", exact_steps));
    }
    // A last step that is a millionth of a step is a rounding of time.end / dt.
    return {.steps = std::size_t(std::max(1.0, std::ceil(exact_steps - 1e-6))), .cfl = cfl};
}

std::string name_of(std::size_t node, const nmbc::Chain& chain) {
    return fmt::format("node {} of {} (interior and ghosts, from 0)", node, chain.nodes());
}

/// The node with the largest velocity, where an instability shows most.
std::string fastest_node(const nmbc::Chain& chain) {
    const auto fastest =
        std::ranges::max_element(chain.velocity(), {}, [](double v) { return std::abs(v); });
    return name_of(std::size_t(fastest - chain.velocity().begin()), chain);
}

/// Steps the chain to the end. After the drive nothing feeds the chain any more: an energy that
/// grows tenfold from there is as unstable as one that is not finite.
Record simulate(const Scene& scene, nmbc::Chain& chain, const Driver& driver, const Plan& plan,
                CsvFile& csv, bool quiet) {
    const double time_step = chain.parameters().time_step;
    Progress progress(plan.steps, quiet);
    Record record;
    double driven_peak = 0;
    const auto unstable = [&](const std::string& what) {
        return Unstable(fmt::format("{} at step {} (t = {:.6g}): {}. Energies up to there: {}",
                                    what, chain.steps(), chain.time(), likely_cause(plan),
                                    csv.path().string()));
    };
    while (chain.steps() < plan.steps) {
        chain.step(driver);
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
        const bool to_be_written = chain.steps() % scene.every == 0 || chain.steps() == plan.steps;
        constexpr std::size_t look_every = 10;  // whatever is written, the peak is the same
        if (!to_be_written && chain.steps() % look_every != 0) {
            continue;
        }
        const double time = chain.time() - time_step / 2;
        const nmbc::Energies energies =
            nmbc::energies(chain, scene.extension, scene.extension + scene.nodes);
        if (to_be_written) {
            record.samples.push_back({time, energies});
            append_energies(csv, time, energies);
        }
        record.peak = std::max(record.peak, energies.total());
        const double total = energies.total();
        if (!std::isfinite(total)) {
            throw unstable(fmt::format("the energy of {} is not finite", fastest_node(chain)));
        }
        if (driver.drives(chain.time())) {
            driven_peak = std::max(driven_peak, total);
        } else if (driven_peak > 0 && total > 10 * driven_peak) {
            throw unstable(fmt::format(
                "the energy has grown to {:.3g} times its peak of the drive, most at {},",
                total / driven_peak, fastest_node(chain)));
        }
    }
    return record;
}

void print_heading(const Scene& scene, const nmbc::Chain& chain, const Plan& plan) {
    const nmbc::ChainParameters& p = chain.parameters();
    fmt::print("scene     {}\n", scene.title);
    fmt::print("lattice   {} horizon {}, G = {}{}\n", scene.family, scene.horizon, scene.G,
               is_damped(scene) ? ", tau = " + scene.tau : "");
    if (scene.left == scene.right) {
        fmt::print("boundary  {}\n", heading_of(scene.left));
    } else {
        fmt::print("left      {}\n", heading_of(scene.left));
        fmt::print("right     {}\n", heading_of(scene.right));
    }
    fmt::print("chain     {} nodes{}, dX = {}, c = {:.6g}\n", scene.nodes,
               scene.extension > 0 ? fmt::format(" (+ {} at each end)", scene.extension) : "",
               p.spacing, p.wave_speed());
    fmt::print("time      {} steps of {:.6g} (cfl = {:.3g}){}\n\n", plan.steps, p.time_step,
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
    nmbc::Lattice lattice = nmbc::make_lattice(table_of(scene, scene.left), scene.G);
    const double omega_max = nmbc::maximum_frequency(lattice) *
                             std::sqrt(scene.youngs_modulus / scene.density) / scene.spacing;
    const auto automatic =
        scene.step || scene.cfl ? AutomaticStep{} : automatic_step(scene, lattice, omega_max);
    const double time_step =
        scene.step ? *scene.step : 2 * scene.cfl.value_or(automatic.cfl) / omega_max;
    require_matched(scene, time_step);
    Plan plan = plan_of(scene, lattice, time_step, omega_max);
    plan.limit = automatic.limit;
    nmbc::Chain chain(std::move(lattice), end_of(scene, scene.left), end_of(scene, scene.right),
                      {.nodes = scene.nodes + 2 * scene.extension,
                       .spacing = scene.spacing,
                       .youngs_modulus = scene.youngs_modulus,
                       .density = scene.density,
                       .time_step = time_step});
    const Driver driver(scene, chain.ghosts(), time_step);
    plan.certified = certify(scene, time_step, plan.cfl);
    CsvFile csv(folder / (scene.name + ".csv"), energies_header);
    std::optional<CsvFile> field;
    if (scene.field) {
        field.emplace(folder / (scene.name + "_field.csv"), field_header);
    }
    if (!quiet) {
        print_heading(scene, chain, plan);
    }
    Record record;
    try {
        record = simulate(scene, chain, driver, plan, csv, quiet);
    } catch (const Unstable&) {
        csv.publish();  // the energies up to there
        throw;
    } catch (const Interrupted&) {
        csv.publish();
        throw;
    }
    csv.publish();
    if (field) {
        append_field(*field, chain, scene.extension);
        field->publish();
    }
    if (record.peak == 0) {
        throw Unstable(fmt::format(
            "there was no energy at any time, so nothing to compare with: the time step of {:.6g} "
            "is too long for drive.duration = {:.6g}, or drive.amplitude too small for doubles. "
            "Energies: {}",
            time_step, scene.drive.duration, csv.path().string()));
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
