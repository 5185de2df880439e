// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>
#include <numbers>

#include "tools/nmbcrun/csv.hpp"
#include "tools/nmbcrun/progress.hpp"
#include "tools/nmbcrun/scene_reader.hpp"

namespace nmbcrun {
namespace {

const nmbc::MatchingTable& table_of(const Scene& scene) {
    const auto* table = nmbc::find_table(nmbc::generated::tables, scene.family, scene.horizon,
                                         scene.order, scene.stride);
    if (table == nullptr) {
        std::string known;
        for (const auto* other : nmbc::generated::tables) {
            known += fmt::format(" {}", other->name);
        }
        throw NoTable(fmt::format(
            "there is no table for family {}, horizon {}, order {}, stride {}; there are:{}",
            scene.family, scene.horizon, scene.order, scene.stride, known));
    }
    return *table;
}

/// The drive's velocities for one step: u reaches its prescribed value at the new time.
class Driver {
  public:
    Driver(const Scene& scene, std::size_t ghosts) : drive_(scene.drive), step_(0) {
        const double reach = drive_.half_width * scene.horizon * scene.spacing;
        // Positions are rounded; a billionth of a spacing decides nothing on purpose.
        const double slack = 1e-9 * scene.spacing;
        for (std::size_t node = 0; node < scene.nodes; ++node) {
            const double X = double(node + 1) * scene.spacing;
            if (std::abs(X - drive_.centre) <= reach + slack) {
                driven_.push_back(node + scene.extension + ghosts);
            }
        }
    }

    bool empty() const { return driven_.empty(); }

    void set_time_step(double time_step) { step_ = time_step; }

    void operator()(std::span<const double> u, std::span<double> v, double time) const {
        if (time > drive_.duration + step_ / 2) {
            return;
        }
        const double phase = std::numbers::pi * std::min(time / drive_.duration, 1.0);
        const double value = drive_.amplitude / 2 * (1 - std::cos(phase));
        for (const std::size_t node : driven_) {
            v[node] = (value - u[node]) / step_;
        }
    }

  private:
    Drive drive_;
    double step_;
    std::vector<std::size_t> driven_;
};

struct Sample {
    double time;
    nmbc::Energies energies;
};

std::string likely_cause(const Scene& scene, double cfl) {
    if (scene.ghosts == nmbc::GhostRule::explicit_rule) {
        return "explicit ghosts are stable only at much smaller time steps; use \"midpoint\"";
    }
    return fmt::format(
        "NMBC{} is not stable at G = {} or needs a time step below cfl = {:.3g}; try a smaller "
        "one, then another G or order",
        scene.order, scene.G, cfl);
}

void print_heading(const Scene& scene, const nmbc::Chain& chain, double cfl, std::size_t steps) {
    const nmbc::ChainParameters& p = chain.parameters();
    const bool midpoint = p.ghost_rule == nmbc::GhostRule::midpoint;
    fmt::print("scene     {}\n", scene.title);
    fmt::print("boundary  NMBC{}, {} horizon {}, stride {}, G = {}, {} ghosts\n", scene.order,
               scene.family, scene.horizon, scene.stride, scene.G,
               midpoint ? "midpoint" : "explicit");
    fmt::print("chain     {} nodes{}, dX = {}, c = {:.6g}\n", scene.nodes,
               scene.extension > 0 ? fmt::format(" (+ {} at each end)", scene.extension) : "",
               p.spacing, p.wave_speed());
    fmt::print("time      {} steps of {:.6g} (cfl = {:.3g})\n\n", steps, p.time_step, cfl);
}

/// About twelve of the samples, and the last.
void print_samples(const std::vector<Sample>& samples, double peak) {
    fmt::print("{:>10}  {:>12}  {:>12}  {:>14}  {:>12}  {:>10}\n", "time", "kinetic", "strain",
               "stabilisation", "total", "of peak");
    const std::size_t every = std::max<std::size_t>(1, samples.size() / 12);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (i % every != 0 && i + 1 != samples.size()) {
            continue;
        }
        const auto& [time, e] = samples[i];
        fmt::print("{:10.4g}  {:12.4e}  {:12.4e}  {:14.4e}  {:12.4e}  {:10.2e}\n", time, e.kinetic,
                   e.strain, e.stabilisation, e.total(), e.total() / peak);
    }
    fmt::print("\n");
}

}  // namespace

void run(const Scene& scene, const std::filesystem::path& folder, bool quiet) {
    const nmbc::MatchingTable& table = table_of(scene);
    nmbc::Lattice lattice = nmbc::make_lattice(table, scene.G);
    nmbc::ChainParameters parameters{.nodes = scene.nodes + 2 * scene.extension,
                                     .spacing = scene.spacing,
                                     .youngs_modulus = scene.youngs_modulus,
                                     .density = scene.density,
                                     .time_step = 0,
                                     .ghost_rule = scene.ghosts};
    const double omega_max =
        nmbc::maximum_frequency(lattice) * parameters.wave_speed() / parameters.spacing;
    parameters.time_step = scene.step ? *scene.step : 2 * *scene.cfl / omega_max;
    const double cfl = parameters.time_step * omega_max / 2;
    if (cfl > 1) {
        throw SceneError(fmt::format(
            "time.step: cfl = {:.4g} is above the interior's limit of 1, a step of {:.6g}", cfl,
            2 / omega_max));
    }
    nmbc::Chain chain(std::move(lattice), nmbc::boundary_coefficients(table, scene.G), parameters);
    const double exact_steps = scene.end / parameters.time_step;
    if (exact_steps > 1e15) {
        throw SceneError(fmt::format("time.end asks for {:.3g} steps; at most 1e15", exact_steps));
    }
    const auto steps = std::size_t(std::ceil(exact_steps - 1e-6));

    Driver driver(scene, chain.ghosts());
    driver.set_time_step(parameters.time_step);
    if (driver.empty()) {
        throw SceneError("drive.centre and drive.half_width select no node");
    }
    EnergyCsv csv(folder / (scene.name + ".csv"));
    std::vector<Sample> samples;
    double peak = 0;
    {
        Progress progress(steps, quiet);
        while (chain.steps() < steps) {
            chain.step(driver);
            progress.update(chain.steps());
            if (!chain.is_finite()) {
                csv.publish();
                throw Unstable(fmt::format(
                    "the state is not finite at step {} (t = {:.6g}), node {} of {} (interior and "
                    "ghosts, from 0): {}. Energies up to there: {}",
                    chain.steps(), chain.time(), chain.first_not_finite(), chain.nodes(),
                    likely_cause(scene, cfl), csv.path().string()));
            }
            if (chain.steps() % scene.every == 0 || chain.steps() == steps) {
                const double time = chain.time() - parameters.time_step / 2;
                samples.push_back(
                    {time, nmbc::energies(chain, scene.extension, scene.extension + scene.nodes)});
                csv.append(time, samples.back().energies);
                peak = std::max(peak, samples.back().energies.total());
            }
        }
    }
    csv.publish();
    if (!quiet) {
        print_heading(scene, chain, cfl, steps);
        print_samples(samples, peak);
    }
    fmt::print("energy left  {:.3e} of the peak\nenergies     {}\n",
               samples.back().energies.total() / peak, csv.path().string());
}

}  // namespace nmbcrun
