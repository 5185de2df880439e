// SPDX-License-Identifier: MIT
/// In which steps of a plane scene strips and a box between its sides do not grow.
#pragma once

#include <array>
#include <cstddef>
#include <nmbc/plane_sides.hpp>
#include <optional>

#include "tools/nmbcrun/plane/plane_scene.hpp"

namespace nmbcrun {

struct SteadyStep {
    double share = 0;      ///< of the longest step that the lattice is stable in; 0: none
    double time_step = 0;  ///< [dX sqrt(rho/E)]
};

/// Of sides whose ghosts move by conditions, the largest leapfrog step, in tenths of the longest
/// that the lattice is stable in, up to which strips of it and a box do not grow. Strips are
/// between such a side and the one opposite where this is fixed, free (of an undamped lattice) or
/// moves by a condition, too, else its like; the box is between the scene's own sides. Nothing of a
/// scene without such sides, or with an influence of its own. On samples: strips of 5, 9 and 20
/// layers and, where a plane of these nodes (extended sides' layers are some) is narrower, of its
/// own, 46 wave numbers along each; a box of 12 x 12 nodes, of fewer where the plane has fewer and
/// of more where its sides need more, run from random velocities to t = 1000 dX sqrt(rho/E). In
/// steps below a tenth of the lattice's longest strips alone are looked at.
///
/// stable [dX sqrt(rho/E)]: the longest step that is stable between these sides without what their
/// conditions feed in; none beyond 0.95 of it is looked at.
std::optional<SteadyStep> steady_step(const PlaneScene& scene, const nmbc::PlaneSides& sides,
                                      const std::array<std::size_t, 2>& nodes, double stable);

/// Whether such strips, or the box, grow in steps of this length [dX sqrt(rho/E)].
bool bodies_grow_in(const PlaneScene& scene, const nmbc::PlaneSides& sides,
                    const std::array<std::size_t, 2>& nodes, double time_step);

}  // namespace nmbcrun
