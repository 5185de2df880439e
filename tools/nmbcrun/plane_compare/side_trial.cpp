// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane_compare/side_trial.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tools/nmbcrun/output/processor_clock.hpp"
#include "tools/nmbcrun/plane_compare/side_candidates.hpp"

namespace nmbcrun {
namespace {

std::vector<double> displacements_of(const PlaneSimulation& simulation) {
    const std::array<std::size_t, 2>& nodes = simulation.scene().nodes;
    std::vector<double> u;
    u.reserve(2 * nodes[0] * nodes[1]);
    for (const std::size_t a : {0U, 1U}) {
        for (std::size_t y = 0; y < nodes[1]; ++y) {
            const auto row = simulation.plane().displacement(a).subspan(simulation.entry(0, y));
            u.insert(u.end(), row.begin(), row.begin() + std::ptrdiff_t(nodes[0]));
        }
    }
    return u;
}

/// Runs to the end, and calls look() at the start and after every so many steps.
template <class Look>
void run_looking(PlaneSimulation& simulation, std::size_t every, const Advance& advance,
                 const Look& look) {
    look();
    const double part = double(every) / double(simulation.plan().steps);
    while (simulation.plane().steps() + every <= simulation.plan().steps) {
        simulation.advance(every);
        look();
        advance(part);
    }
}

}  // namespace

PlaneSamples samples_of(PlaneSimulation& simulation, const Advance& advance) {
    const auto nodes = double(simulation.scene().nodes[0]) * double(simulation.scene().nodes[1]);
    constexpr double most_numbers = 1e8;
    const double times = std::clamp(most_numbers / (2 * nodes), 4.0, 100.0);
    PlaneSamples samples;
    samples.every = std::max<std::size_t>(1, simulation.plan().steps / std::size_t(times));
    run_looking(simulation, samples.every, advance, [&] {
        samples.u.push_back(displacements_of(simulation));
        for (const double u : samples.u.back()) {
            samples.largest = std::max(samples.largest, std::abs(u));
        }
        samples.peak = std::max(samples.peak, simulation.energies().total());
    });
    return samples;
}

SideTrial run_trial(PlaneSimulation& simulation, const PlaneSamples& reference,
                    const Advance& advance) {
    double largest = 0;
    std::size_t time = 0;
    run_looking(simulation, reference.every, advance, [&] {
        const std::vector<double> u = displacements_of(simulation);
        const std::vector<double>& there = reference.u[time++];
        for (std::size_t i = 0; i < u.size(); ++i) {
            const double difference = std::abs(u[i] - there[i]);
            if (!(difference <= largest)) {  // of what is not a number, too
                largest = std::isfinite(difference) ? difference
                                                    : std::numeric_limits<double>::infinity();
            }
        }
    });
    return {.error = largest / reference.largest,
            .energy_left = simulation.energies().total() / reference.peak};
}

PlaneSimulation small_box(const PlaneScene& scene, const PlaneSideChoice& side) {
    PlaneScene box = with_sides(scene, side);
    box.sides = {side, side, side, side};
    const std::size_t nodes = 16 + 2 * nmbc::horizon_of(scene.radius_squared);
    box.nodes = {nodes, nodes};
    box.force.reset();
    box.drive.reset();
    box.loads.clear();
    box.fracture.reset();
    // Off the axes and diagonals of symmetry.
    box.initial = PlaneInitial{.amplitude = scene.spacing,
                               .centre = {7 * scene.spacing, 8 * scene.spacing},
                               .width = scene.spacing / 2};
    box.step.reset();
    box.cfl.reset();
    return PlaneSimulation(box, true);
}

bool grows(PlaneSimulation simulation, std::size_t steps, const Advance& advance) {
    constexpr std::size_t looks = 400;
    const double first = simulation.plane().energies().staggered;
    std::array<double, 4> most{};  // of each quarter
    for (std::size_t look = 0; look < looks; ++look) {
        simulation.advance(std::max<std::size_t>(1, steps / looks));
        const double energy = simulation.plane().energies().staggered;
        if (!std::isfinite(energy)) {
            return true;
        }
        double& of_quarter = most[look * most.size() / looks];
        of_quarter = std::max(of_quarter, energy);
        advance(1.0 / looks);
    }
    constexpr double roundings = 1e-18;  // of what is left when all has gone
    return most[3] > most[1] && most[3] > roundings * first;
}

Burst timed_burst(PlaneSimulation& simulation) {
    const auto nodes = double(simulation.plane().grid().nx) * double(simulation.plane().grid().ny);
    constexpr double node_steps = 4e5;  // some 20 ms
    const std::size_t steps = 2 + std::size_t(node_steps / nodes);
    const auto state = simulation.state();
    const std::size_t begun = simulation.plane().steps();
    const double start = seconds_of_this_process();
    simulation.advance(steps);
    const double taken = seconds_of_this_process() - start;
    simulation.resume(begun, state);
    return {taken, taken / double(steps)};
}

double relative_cost(PlaneSimulation& simulation, PlaneSimulation& other, const Advance& advance) {
    std::vector<double> ratios;
    for (std::size_t pair = 0; pair < cost_pairs; ++pair) {
        const double own = timed_burst(simulation).a_step;
        ratios.push_back(own / timed_burst(other).a_step);
        advance(1.0 / double(cost_pairs));
    }
    std::ranges::nth_element(ratios, ratios.begin() + cost_pairs / 2);
    return ratios[cost_pairs / 2];
}

}  // namespace nmbcrun
