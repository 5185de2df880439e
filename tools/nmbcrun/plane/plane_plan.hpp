// SPDX-License-Identifier: MIT
/// The time steps of a plane scene.
#pragma once

#include <array>
#include <cstddef>
#include <nmbc/plane_sides.hpp>
#include <optional>

#include "tools/nmbcrun/plane/plane_scene.hpp"
#include "tools/nmbcrun/plane/steady_step.hpp"
#include "tools/nmbcrun/scene/step_plan.hpp"

namespace nmbcrun {

/// Of the longest stable step, where a scene gives none.
inline constexpr double of_stable_by_default = 0.9;

struct PlanePlan : StepPlan {
    double of_stable = 0;  ///< dt over the longest step that is stable between these sides
    std::optional<SteadyStep> steady{};  ///< steady_step() of default steps that heed it
};

/// In the steps that the scene gives, or else in of_stable_by_default of the longest stable ones,
/// or shorter ones where strips or a box between its sides grow or what moves it is faster. nodes:
/// along x and y, those of extended sides included. Throws Unstable where the steps are too long
/// for the sides, SceneError as steps_until().
PlanePlan plan_of(const PlaneScene& scene, const nmbc::PlaneSides& sides,
                  const std::array<std::size_t, 2>& nodes);

/// Node-steps a second of one fast core.
double pace_of(const PlaneScene& scene);

}  // namespace nmbcrun
