// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "generator/exact/rational.hpp"
#include "generator/exact/rounded_text.hpp"
#include "tools/nmbcrun/plane/load_steps.hpp"
#include "tools/nmbcrun/plane/plane_spectrum.hpp"
#include "tools/nmbcrun/plane/side_prospect.hpp"
#include "tools/nmbcrun/plane/steady_step.hpp"
#include "tools/nmbcrun/sources/start_at_edge.hpp"

namespace nmbcrun {
namespace {

std::string words_of(const PlaneSimulation& simulation, std::size_t side) {
    const PlaneSideChoice& choice = simulation.scene().sides[side];
    return choice.kind == SideKind::extended
               ? fmt::format("extended by {} nodes", simulation.extension()[side])
               : heading_of(choice);
}

/// Where a load pulls bonds apart within one step.
std::vector<std::string> warnings_of_jumps(const PlaneSimulation& simulation) {
    std::vector<std::string> warnings;
    const double time_step = simulation.plan().time_step;
    for (const LoadStep& load : steps_of_loads(simulation.scene())) {
        if (time_step > load.longest) {
            const double ratio = time_step / load.longest;
            warnings.push_back(fmt::format(
                "in {} step {} moves its nodes by {:.3g} times the critical stretch times dX: "
                "bonds may break for that alone. Give {}time.step below {:.3g}",
                load.is_force ? "the first" : "one", load.table,
                load.is_force ? ratio * ratio : ratio, load.is_force ? "it a rise, or " : "",
                load.longest));
        }
    }
    return warnings;
}

/// Steps that the scene gives are taken, whatever grows in them, and default ones where something
/// grows in all.
std::string warning_of_growth(const PlaneSimulation& simulation) {
    const PlaneScene& scene = simulation.scene();
    const PlanePlan& plan = simulation.plan();
    const nmbc::PlaneSides& sides = simulation.plane().sides();
    const nmbc::PlaneParameters& p = simulation.plane().parameters();
    const std::array nodes{p.nx, p.ny};
    const double rate = rate_of(scene);
    if (plan.steady && plan.steady->share > 0) {
        return "";  // default steps are none in which they grow
    }
    if (!bodies_grow_in(scene, sides, nodes, plan.time_step * rate)) {
        return "";
    }
    const double stable = plan.time_step / plan.of_stable;
    const auto steady = plan.steady ? plan.steady : steady_step(scene, sides, nodes, stable * rate);
    const double longest = steady->time_step / rate;
    std::string others;
    if (steady->share == 0) {
        others = ", as in a tenth of the lattice's longest";
    } else if (longest < plan.time_step) {
        others =
            fmt::format(": not up to time.step = {} (cfl = {})", nmbcgen::rounded_down(longest, 6),
                        nmbcgen::rounded_down(longest / plan.time_step * plan.cfl, 3));
    }
    return fmt::format("in steps of {:.6g} (cfl = {:.3g}) strips or a box between its sides grow{}",
                       plan.time_step, plan.cfl, others);
}

/// Sides that let waves out and have nothing behind them.
bool lets_go(SideKind kind) {
    return kind == SideKind::passive || kind == SideKind::nmbc || kind == SideKind::higdon;
}

/// Where [initial] moves the outermost nodes at sides that let waves out.
std::vector<std::string> warnings_of_start(const PlaneSimulation& simulation) {
    const std::array<double, 4>& shares = simulation.initial_at_sides();
    std::vector<std::string> warnings;
    for (std::size_t side = 0; side < shares.size(); ++side) {
        if (lets_go(simulation.scene().sides[side].kind)) {
            warnings.push_back(
                warning_of_start_at(fmt::format("{} side", plane_side_names[side]), shares[side]));
        }
    }
    return warnings;
}

/// Where a load stays on, alone, and all sides let the body go. Several may balance each other.
std::string warning_of_lasting_load(const PlaneScene& scene) {
    const auto has_side = [&](auto is_such) {
        return std::ranges::any_of(scene.sides, is_such, &PlaneSideChoice::kind);
    };
    const bool is_held = has_side([](SideKind kind) {
        return kind == SideKind::fixed || kind == SideKind::extended || kind == SideKind::sponge ||
               kind == SideKind::pml;
    });
    std::vector<std::string> lasting;
    for (const PlaneLoad& load : scene.loads) {
        if (load.given == Given::force && load.file.empty() && load.until >= scene.end) {
            lasting.push_back(load.name);
        }
    }
    return is_held || !has_side(lets_go) || lasting.size() != 1
               ? ""
               : fmt::format(
                     "{} stays on, and no side holds the body: sides that let waves out give way "
                     "to a lasting load as free ones do, in the end",
                     lasting.front());
}

/// Where boundary.allow_unstable has nothing to allow.
std::string warning_of_idle_key(const PlaneScene& scene) {
    const bool may_explode =
        scene.is_bond_based() && !nmbc::is_positive(bonds_of(scene)) && scene.has(SideKind::free);
    return scene.allow_unstable && !scene.may_grow() && !may_explode
               ? "boundary.allow_unstable does nothing: no side of this scene may feed energy in"
               : "";
}

}  // namespace

std::string heading_of(const PlaneSimulation& simulation) {
    const PlaneScene& scene = simulation.scene();
    const nmbc::PlaneModel model = model_of(scene);
    std::string text = fmt::format("scene     {}\n", scene.title);
    text += scene.is_bond_based()
                ? fmt::format("lattice   bond2d, radius {} (squared), weights {:.6g}\n",
                              scene.radius_squared, fmt::join(scene.weights, ", "))
                : fmt::format(
                      "lattice   nopd2d, radius {} (squared), nu = {}, plane {}, G = {}{}{}\n",
                      scene.radius_squared, nmbcgen::to_string(scene.nu),
                      scene.state == nmbc::StressState::plane_stress ? "stress" : "strain", scene.G,
                      scene.tau == 0 ? "" : ", tau = " + nmbcgen::to_string(scene.tau),
                      scene.influence.empty()
                          ? ""
                          : fmt::format(", influence {:.6g}", fmt::join(scene.influence, ", ")));
    const bool alike = std::ranges::all_of(
        scene.sides, [&](const PlaneSideChoice& side) { return side == scene.sides[0]; });
    if (alike && scene.sides[0].kind != SideKind::extended) {
        text += fmt::format("sides     {}\n", words_of(simulation, 0));
    } else {
        text +=
            fmt::format("sides     left {}, right {}, bottom {}, top {}\n", words_of(simulation, 0),
                        words_of(simulation, 1), words_of(simulation, 2), words_of(simulation, 3));
    }
    text += fmt::format("stable    {}\n", evidence_of(scene));
    if (const auto stretch = critical_stretch(scene)) {
        const double energy = nmbc::fracture_energy(bonds_of(scene), *stretch);
        text += fmt::format(
            "fracture  bonds break at a stretch of {:.6g}: {:.4g} per area along an "
            "axis\n",
            *stretch, energy * scene.youngs_modulus * scene.spacing);
    }
    const double speed = rate_of(scene) * scene.spacing;
    return text + fmt::format("plane     {} x {} nodes, dX = {}, c_P = {:.6g}, c_S = {:.6g}\n",
                              scene.nodes[0], scene.nodes[1], scene.spacing,
                              speed * model.speed_P(), speed * model.speed_S());
}

std::string warning_of_strains(const PlaneSimulation& simulation, std::string_view when) {
    const double strain = simulation.largest_strain();
    return strain > 1 ? fmt::format(
                            "{} neighbours are up to {:.3g} times dX further apart, or nearer, "
                            "than at rest: the model is of small strains",
                            when, strain)
                      : "";
}

std::vector<std::string> warnings_of(const PlaneSimulation& simulation) {
    std::vector<std::string> warnings = simulation.warnings();
    const auto short_waves = warnings_of_short_waves(simulation);
    warnings.insert(warnings.end(), short_waves.begin(), short_waves.end());
    const auto jumps = warnings_of_jumps(simulation);
    const bool begins = simulation.scene().initial && simulation.plane().steps() == 0;
    warnings.insert(warnings.end(), jumps.begin(), jumps.end());
    warnings.insert(warnings.end(),
                    {warning_of_idle_key(simulation.scene()), warning_of_growth(simulation),
                     begins ? warning_of_strains(simulation, "at the start") : "",
                     warning_of_short_run(simulation.scene())});
    if (begins) {
        const auto start = warnings_of_start(simulation);
        warnings.insert(warnings.end(), start.begin(), start.end());
    }
    warnings.push_back(warning_of_lasting_load(simulation.scene()));
    std::erase(warnings, "");
    return warnings;
}

}  // namespace nmbcrun
