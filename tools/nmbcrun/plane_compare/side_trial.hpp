// SPDX-License-Identifier: MIT
/// A plane scene run beside what comes without sides.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/nmbcrun/output/work.hpp"
#include "tools/nmbcrun/plane/plane_simulation.hpp"

namespace nmbcrun {

/// u of the scene's nodes, x and y, at equal distances in time.
struct PlaneSamples {
    std::size_t every = 1;  ///< steps
    std::vector<std::vector<double>> u{};
    double largest = 0;  ///< |u| of any node, at any of these times
    double peak = 0;     ///< of the energy of the scene's nodes, likewise
};

/// At a hundred times of the run, or fewer of many nodes. Runs it to its end.
PlaneSamples samples_of(PlaneSimulation& simulation, const Advance& advance);

struct SideTrial {
    double error = 0;        ///< max |u - u_ref| over max |u_ref|; infinite where u is not finite
    double energy_left = 0;  ///< over the peak of the reference
};

/// Runs it to its end. The reference is of as many such steps.
SideTrial run_trial(PlaneSimulation& simulation, const PlaneSamples& reference,
                    const Advance& advance);

/// A pulse of one node of the scene's lattice in a small box between such sides.
PlaneSimulation small_box(const PlaneScene& scene, const PlaneSideChoice& side);

/// Whether the energy grows over so many steps.
bool grows(PlaneSimulation simulation, std::size_t steps, const Advance& advance);

/// Processor time [s] of some steps from the state that a simulation is in, and stays in.
struct Burst {
    double seconds = 0;
    double a_step = 0;
};
Burst timed_burst(PlaneSimulation& simulation);

/// Time of a step of the simulation over that of the other: the median of so many pairs of bursts.
double relative_cost(PlaneSimulation& simulation, PlaneSimulation& other, const Advance& advance);
inline constexpr std::size_t cost_pairs = 21;

}  // namespace nmbcrun
