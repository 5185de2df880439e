// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/exact/rational.hpp"
#include "tools/nmbcrun/scene/printable.hpp"

namespace nmbcrun {
namespace {

std::string words_of(const PlaneSimulation& simulation, std::size_t side) {
    const PlaneSideChoice& choice = simulation.scene().sides[side];
    return choice.kind == SideKind::extended
               ? fmt::format("extended by {} nodes", simulation.extension()[side])
               : heading_of(choice);
}

}  // namespace

std::string heading_of(const PlaneSimulation& simulation) {
    const PlaneScene& scene = simulation.scene();
    const nmbc::PlaneModel model = model_of(scene);
    std::string text = fmt::format("scene     {}\n", scene.title);
    text += scene.is_bond_based()
                ? fmt::format("lattice   bond2d, radius {} (squared), weights {:.6g}\n",
                              scene.radius_squared, fmt::join(scene.weights, ", "))
                : fmt::format("lattice   nopd2d, radius {} (squared), nu = {}, plane {}, G = {}\n",
                              scene.radius_squared, nmbcgen::to_string(scene.nu),
                              scene.state == nmbc::StressState::plane_stress ? "stress" : "strain",
                              scene.G);
    const bool alike = std::ranges::all_of(
        scene.sides, [&](const PlaneSideChoice& side) { return side == scene.sides[0]; });
    if (alike && scene.sides[0].kind != SideKind::extended) {
        text += fmt::format("sides     {}\n", words_of(simulation, 0));
    } else {
        text +=
            fmt::format("sides     left {}, right {}, bottom {}, top {}\n", words_of(simulation, 0),
                        words_of(simulation, 1), words_of(simulation, 2), words_of(simulation, 3));
    }
    const double speed = rate_of(scene) * scene.spacing;
    return text + fmt::format("plane     {} x {} nodes, dX = {}, c_P = {:.6g}, c_S = {:.6g}\n",
                              scene.nodes[0], scene.nodes[1], scene.spacing,
                              speed * model.speed_P(), speed * model.speed_S());
}

std::string heading_of(const PlanePlan& plan) {
    return fmt::format("{:.6g} (cfl = {:.3g}){}", plan.time_step, plan.cfl,
                       plan.limit.empty() ? "" : ": " + plan.limit);
}

void print_warning(const PlaneSimulation& simulation) {
    if (!simulation.warning().empty()) {
        fmt::print(stderr, "nmbcrun: warning: {}\n", printable(simulation.warning()));
    }
}

}  // namespace nmbcrun
