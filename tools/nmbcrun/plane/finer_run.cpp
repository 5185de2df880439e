// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/finer_run.hpp"

#include <algorithm>
#include <cmath>

#include "generator/closures/plane_summation_by_parts.hpp"

namespace nmbcrun {
namespace {

/// Whether a side of the scene is closed by sums by parts on a finer lattice. Where a mirror is
/// about, free ones stay what they are: nodes are dX/3 apart then, and from a surface that is dX/2
/// beyond the original's nodes none would be where these are.
bool is_closed_by_parts(const PlaneScene& scene, SideKind kind) {
    return ends_body(kind) && !scene.is_bond_based() &&
           scene.radius_squared <= nmbcgen::largest_closed_radius_squared &&
           !(kind == SideKind::free && scene.has(SideKind::mirror));
}

}  // namespace

std::array<PlaneSideChoice, 4> without_artificial(std::array<PlaneSideChoice, 4> sides) {
    for (PlaneSideChoice& side : sides) {
        if (is_artificial(side.kind)) {
            side = {.kind = SideKind::extended, .layer = 0};
        }
    }
    return sides;
}

SameBody finer_body(const PlaneScene& scene, const nmbc::PlaneSides& own) {
    auto sides = without_artificial(scene.sides);
    bool is_midway = false;
    for (PlaneSideChoice& side : sides) {
        if (is_closed_by_parts(scene, side.kind)) {
            side = {.kind = SideKind::sbp};
        }
        is_midway = is_midway || side.kind == SideKind::free || side.kind == SideKind::mirror;
    }
    return same_body(scene, own, sides, is_midway ? 3 : 2);
}

ReferenceRun finer_run(SameBody body, double time_step) {
    const std::size_t ratio = body.scene.original->ratio;
    const PlanePlan plan = PlaneSimulation(body.scene, body.sides).plan();
    constexpr double of_stable = 0.95;  // more than a scene's 0.9, as the limit differs with size
    const double allowed = of_stable * plan.time_step / plan.of_stable;
    const auto steps = std::max(ratio, std::size_t(std::ceil(time_step / allowed)));
    body.scene.step = time_step / double(steps);
    return {.simulation = PlaneSimulation(body.scene, body.sides), .steps = steps, .ratio = ratio};
}

}  // namespace nmbcrun
