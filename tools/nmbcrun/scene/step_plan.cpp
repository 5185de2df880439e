// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/step_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {

std::size_t steps_until(double end, double time_step) {
    const double exact_steps = end / time_step;
    if (!std::isfinite(exact_steps)) {
        throw SceneError(
            fmt::format("time.end = {:g} is too long for time steps of {:g}, which domain.spacing, "
                        "the material or time.step and time.cfl ask for",
                        end, time_step));
    }
    if (exact_steps > 1e15) {
        throw SceneError(fmt::format("time.end asks for {:.3g} steps; at most 1e15", exact_steps));
    }
    // A last step that is a millionth of a step is a rounding of time.end / dt.
    return std::size_t(std::max(1.0, std::ceil(exact_steps - 1e-6)));
}

std::string heading_of(const StepPlan& plan) {
    return fmt::format("{:.6g} (cfl = {:.3g}){}", plan.time_step, plan.cfl,
                       plan.limit.empty() ? "" : ": " + plan.limit);
}

}  // namespace nmbcrun
