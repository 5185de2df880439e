// SPDX-License-Identifier: MIT
/// What closed sides of a plane are judged by: the same body on a finer lattice.
#pragma once

#include <cstddef>

#include "tools/nmbcrun/plane/plane_simulation.hpp"
#include "tools/nmbcrun/plane/same_body.hpp"

namespace nmbcrun {

/// A run beside which another one is looked at.
struct ReferenceRun {
    PlaneSimulation simulation;
    std::size_t steps = 1;  ///< of it to one of the other's
    std::size_t ratio = 1;  ///< the other's dX over its own

    void advance() { simulation.advance(steps); }
};

/// The sides with such in the place of artificial ones that are so far off that nothing returns.
std::array<PlaneSideChoice, 4> without_artificial(std::array<PlaneSideChoice, 4> sides);

/// The body of a scene between its own sides, as sides_of() has them, on a lattice of dX/2 that is
/// as large in its own dX; dX/3 where its nodes lie midway from surfaces or mirrors in both. Sides
/// that end the body are closed by summation by parts where the lattice has that, but for free ones
/// where a mirror is about; artificial ones are far off. Throws as same_body() does.
SameBody finer_body(const PlaneScene& scene, const nmbc::PlaneSides& own);

/// Of finer_body(): takes a whole number of steps to one of time_step [time]. Throws as
/// PlaneSimulation does.
ReferenceRun finer_run(SameBody body, double time_step);

}  // namespace nmbcrun
