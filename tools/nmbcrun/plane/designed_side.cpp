// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/designed_side.hpp"

#include <fmt/format.h>

#include <functional>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "generator/support/progress_line.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/plane/plane_lattice.hpp"

namespace nmbcrun {

nmbcgen::SideTask side_task_of(const PlaneScene& scene) {
    nmbcgen::SideTask task{.family = "nopd2d",
                           .choice = {.radius_squared = scene.radius_squared},
                           .g = nmbcgen::Rational(scene.G / std::numbers::pi),
                           .time_step = 0};
    if (scene.is_bond_based()) {
        task.family = "bond2d";
        task.choice.weights.assign(scene.weights.begin(), scene.weights.end());
    } else {
        task.choice.poisson = scene.nu;
        task.choice.plane_strain = scene.state == nmbc::StressState::plane_strain;
    }
    return task;
}

DesignedPassiveSide designed_side_of(const PlaneScene& scene, bool quiet) {
    if (scene.radius_squared > nmbcgen::largest_side_radius_squared) {
        throw SceneError(
            fmt::format("passive sides are designed for model.radius2 up to {}, not {}",
                        nmbcgen::largest_side_radius_squared, scene.radius_squared));
    }
    if (!scene.influence.empty()) {
        throw SceneError(
            "passive sides are designed for constant influence: leave model.influence out, or take "
            "another kind");
    }
    const bool has_surface =
        scene.has(SideKind::free) || scene.has(SideKind::sbp) || scene.has(SideKind::kernel);
    try {
        nmbcgen::SideTask task = side_task_of(scene);
        task.has_null_lagrangian = !has_surface;
        for (const PlaneSideChoice& side : scene.sides) {
            if (side.kind == SideKind::passive) {
                task.layers = side.layer;
            }
        }
        std::optional<nmbcgen::ProgressLine> line;
        nmbcgen::DesignProgress progress;
        if (!quiet) {
            line.emplace("nmbcrun: designing passive sides");
            progress = std::ref(*line);
        }
        nmbcgen::DesignedSide design = nmbcgen::passive_side(task, progress);
        nmbc::PassiveSide side = for_runtime(design);
        side.made_for = model_of(scene);
        return {std::move(task), std::move(design), std::move(side)};
    } catch (const std::domain_error& error) {
        throw SceneError(fmt::format(
            "no passive side was found for this lattice: {}. Try another G, or another kind",
            error.what()));
    }
}

}  // namespace nmbcrun
