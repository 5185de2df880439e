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

/// Whether the energy grows over so many steps, from a pulse of one node of this lattice in a small
/// box between such sides.
bool grows(const PlaneScene& scene, const PlaneSideChoice& side, std::size_t steps,
           const Advance& advance);

/// Time of a step of the simulation over that of the other: the median of pairs, all from the
/// state that the two are in.
double relative_cost(PlaneSimulation& simulation, PlaneSimulation& other);

}  // namespace nmbcrun
