// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/chart/trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/nmbcrun/certification/time_step.hpp"
#include "tools/nmbcrun/compare/reference.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun {
namespace {

/// Calls look(simulation) after every step and collects the samples.
template <class Look>
Samples run_sampled(Simulation& simulation, const Advance& advance, Look look) {
    const std::size_t every = simulation.plan().steps / sample_count;
    Samples samples;
    samples.reserve(sample_count + 1);
    const auto sample = [&] {
        const auto u = interior(simulation.chain());
        samples.emplace_back(u.begin(), u.end());
    };
    sample();
    while (!simulation.is_done()) {
        simulation.step();
        look(simulation);
        if (simulation.chain().steps() % every == 0) {
            sample();
            advance(1 / double(sample_count));
        }
    }
    return samples;
}

}  // namespace

Scene in_steps_of(Scene scene, double cfl) {
    const double omega_max = highest_frequency(scene, lattice_of(scene));
    const double part = scene.end / double(sample_count);
    const double steps = std::ceil(part * omega_max / (2 * cfl) * (1 - 1e-12));
    scene.step = part / steps;
    scene.cfl.reset();
    return scene;
}

nmbc::Chain chain_between(const Scene& scene, const nmbc::ChainEnd& left,
                          const nmbc::ChainEnd& right) {
    return {lattice_of(scene), left, right, parameters_of(scene, scene.step.value())};
}

Samples samples_of(const Scene& scene, const Advance& advance) {
    Simulation simulation(scene);
    return run_sampled(simulation, advance, [](const Simulation&) {});
}

Samples samples_without_ends(const Scene& scene, const Advance& advance) {
    Samples samples = samples_of(endless(scene, scene.step.value()), advance);
    const auto is_still = [](const std::vector<double>& u) {
        return std::ranges::all_of(u, [](double value) { return value == 0; });
    };
    if (std::ranges::all_of(samples, is_still)) {
        throw nothing_to_compare_with();
    }
    return samples;
}

double relative_difference(const Samples& u, const Samples& v) {
    double difference = 0;
    double largest = 0;
    for (std::size_t sample = 0; sample < v.size(); ++sample) {
        for (std::size_t node = 0; node < v[sample].size(); ++node) {
            const double one = std::abs(u[sample][node] - v[sample][node]);
            if (!std::isfinite(one)) {
                return std::numeric_limits<double>::infinity();
            }
            difference = std::max(difference, one);
            largest = std::max(largest, std::abs(v[sample][node]));
        }
    }
    return difference == 0 ? 0 : difference / largest;
}

Trial run_trial(const Scene& scene, const Samples& same_steps, const Samples& fine_steps,
                const Advance& advance) {
    Simulation simulation(scene);
    double peak = 0;
    const Samples samples = run_sampled(simulation, advance, [&](const Simulation& running) {
        constexpr std::size_t look_every = 10;  // as nmbcrun run has it
        if (running.chain().steps() % look_every == 0) {
            peak = std::max(peak, running.energies().total());
        }
    });
    const double left = simulation.energies().total();
    return {.cfl = simulation.plan().cfl,
            .steps = simulation.plan().steps,
            .objection = simulation.plan().objection,
            .boundary_error = relative_difference(samples, same_steps),
            .total_error = relative_difference(samples, fine_steps),
            .energy_left = std::isfinite(left) ? left / std::max(peak, left)
                                               : std::numeric_limits<double>::infinity()};
}

}  // namespace nmbcrun
