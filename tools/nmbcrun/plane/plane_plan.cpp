// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nmbc/plane_stability.hpp>
#include <string>
#include <tuple>
#include <utility>

#include "generator/exact/rounded_text.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/step_warnings.hpp"
#include "tools/nmbcrun/plane/load_steps.hpp"
#include "tools/nmbcrun/plane/plane_lattice.hpp"
#include "tools/nmbcrun/stepping/plane_stepping.hpp"

namespace nmbcrun {
namespace {

/// What the longest step is of.
const char* limit_of(const PlaneScene& scene) {
    return scene.may_grow() ? "what the lattice allows, whatever its sides feed in"
                            : "what is stable between these sides";
}

/// Steps below `stable` in which nothing between the sides grows, where there are such, and
/// that are short enough for what moves the scene.
void choose_step(const PlaneScene& scene, const nmbc::PlaneSides& sides,
                 const std::array<std::size_t, 2>& nodes, double stable, PlanePlan& plan) {
    plan.time_step = of_stable_by_default * stable;
    plan.limit = fmt::format("{} of {}", of_stable_by_default, limit_of(scene));
    plan.steady = steady_step(scene, sides, nodes, stable * rate_of(scene));
    if (plan.steady) {
        const double longest = plan.steady->time_step / rate_of(scene);
        if (plan.steady->share == 0) {
            plan.limit += ": strips or a box between them grow in a tenth of it, too";
        } else if (plan.steady->share < of_stable_by_default && longest < plan.time_step) {
            plan.time_step = longest;
            plan.limit = fmt::format(
                "{} of what the lattice allows: in longer ones strips or a box between its sides "
                "grow",
                plan.steady->share);
        }
    }
    for (const LoadStep& load : steps_of_loads(scene)) {
        if (load.fine < plan.time_step) {
            plan.time_step = load.fine;
            plan.limit = fmt::format(
                "{} moves its nodes by at most a tenth of the critical stretch times dX in {}",
                load.table, load.is_force ? "the first" : "each");
        }
    }
    constexpr double per_time = 20;
    const auto limit = [&](double time, const char* key) {
        if (time > 0 && time / per_time < plan.time_step) {
            plan.time_step = time / per_time;
            plan.limit = fmt::format("1/{} of {}", per_time, key);
        }
    };
    if (scene.force) {
        const ForceHistory& history = scene.force->history;
        limit(history.duration, "force.duration");
        limit(history.frequency > 0 ? 1 / history.frequency : 0, "the period of force.frequency");
    }
    if (scene.drive) {
        limit(scene.drive->duration, "drive.duration");
    }
    for (const PlaneLoad& load : scene.loads) {
        limit(load.rise, "a load's rise");
    }
}

}  // namespace

PlanePlan plan_of(const PlaneScene& scene, const nmbc::PlaneSides& sides,
                  const std::array<std::size_t, 2>& nodes) {
    const nmbc::PlaneModel model = model_of(scene);
    const double rate = rate_of(scene);
    const double interior = 2 / std::sqrt(nmbc::highest_eigenvalue(model)) / rate;
    const double stable = nmbc::longest_step(model, sides, nodes[0], nodes[1]) / rate;
    PlanePlan plan;
    if (scene.step || scene.cfl) {
        plan.time_step = scene.step ? *scene.step : *scene.cfl * interior;
    } else {
        choose_step(scene, sides, nodes, stable, plan);
    }
    plan.cfl = plan.time_step / interior;
    plan.of_stable = plan.time_step / stable;
    if (!(plan.of_stable < 1)) {
        constexpr double below = 1 - 1e-9;  // the limit itself is not stable
        const auto in_words = [&](double step) {
            return std::pair(nmbcgen::rounded_down(step, 6),
                             nmbcgen::rounded_down(step / interior, 3));
        };
        const auto [longest, largest] = in_words(below * stable);
        auto [step, cfl] = std::pair(longest, largest);
        std::string growth;
        if (const auto steady = steady_step(scene, sides, nodes, stable * rate);
            steady && steady->share > 0) {
            std::tie(step, cfl) = in_words(std::min(below * stable, steady->time_step / rate));
            growth = fmt::format(
                ", and strips and a box between its sides do not grow up to {} (cfl = {})", step,
                cfl);
        } else if (steady) {
            growth = ", and strips or a box between its sides grow in a tenth of it, too";
        }
        throw Unstable(fmt::format(
            "steps of {:.6g} (cfl = {:.3g}) are too long: {} is {} (cfl = {}){}. Give time.{} or "
            "less",
            plan.time_step, plan.cfl, limit_of(scene), longest, largest, growth,
            scene.step ? "step = " + step : "cfl = " + cfl));
    }
    plan.steps = steps_until(scene.end, plan.time_step);
    return plan;
}

double pace_of(const PlaneScene& scene) {
    return scene.is_bond_based() ? bond_pace : plane_pace;
}

}  // namespace nmbcrun
