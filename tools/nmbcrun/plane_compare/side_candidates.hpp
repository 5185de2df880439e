// SPDX-License-Identifier: MIT
/// The sides that a chart of a plane scene compares.
#pragma once

#include <nmbc/plane_sides.hpp>
#include <string>
#include <vector>

#include "tools/nmbcrun/plane/plane_scene.hpp"

namespace nmbcrun {

struct SideCandidate {
    std::string name;
    PlaneSideChoice side;
};

/// Every kind there is for the lattice of the scene. Sponges and perfectly matched layers of
/// several widths, whose losses are to be tuned.
std::vector<SideCandidate> side_candidates(const PlaneScene& scene);

/// The scene with such sides in the place of its artificial ones, that may feed energy in.
PlaneScene with_sides(PlaneScene scene, const PlaneSideChoice& side);

}  // namespace nmbcrun
