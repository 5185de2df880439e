// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/finer_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/closures/plane_summation_by_parts.hpp"
#include "tools/nmbcrun/plane/same_body.hpp"

namespace nmbcrun {
namespace {

/// Free sides beside a mirror stay what they are: half as many dX on, no node would be where one
/// of the original is.
bool has_sums_by_parts(const PlaneScene& scene) {
    return !scene.is_bond_based() &&
           scene.radius_squared <= nmbcgen::largest_closed_radius_squared &&
           !(scene.has(SideKind::free) && scene.has(SideKind::mirror));
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

ReferenceRun finer_run(const PlaneSimulation& of, double time_step) {
    auto sides = without_artificial(of.scene().sides);
    const bool by_parts = has_sums_by_parts(of.scene());
    bool is_midway = false;
    for (PlaneSideChoice& side : sides) {
        if (by_parts && ends_body(side.kind)) {
            side = {.kind = SideKind::sbp};
        }
        is_midway = is_midway || side.kind == SideKind::free || side.kind == SideKind::mirror;
    }
    const std::size_t ratio = is_midway ? 3 : 2;
    SameBody body = same_body(of, sides, ratio);
    const PlanePlan plan = PlaneSimulation(body.scene, body.sides).plan();
    constexpr double of_stable = 0.95;  // more than a scene's 0.9, as the limit differs with size
    const double allowed = of_stable * plan.time_step / plan.of_stable;
    const auto steps = std::max(ratio, std::size_t(std::ceil(time_step / allowed)));
    body.scene.step = time_step / double(steps);
    return {.simulation = PlaneSimulation(body.scene, body.sides), .steps = steps, .ratio = ratio};
}

}  // namespace nmbcrun
