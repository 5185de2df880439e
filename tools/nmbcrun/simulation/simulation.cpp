// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/simulation/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nmbc/lattice.hpp>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/simulation/certificate.hpp"
#include "tools/nmbcrun/simulation/ends.hpp"
#include "tools/nmbcrun/simulation/tables.hpp"
#include "tools/nmbcrun/simulation/time_step.hpp"

namespace nmbcrun {
namespace {

std::size_t steps_until(double end, double time_step) {
    const double exact_steps = end / time_step;
    if (exact_steps > 1e15) {
        throw SceneError(fmt::format("time.end asks for {:.3g} steps; at most 1e15", exact_steps));
    }
    // A last step that is a millionth of a step is a rounding of time.end / dt.
    return std::size_t(std::max(1.0, std::ceil(exact_steps - 1e-6)));
}

Plan plan_of(const Scene& scene, const nmbc::Lattice& lattice) {
    const double omega_max = nmbc::maximum_frequency(lattice) *
                             std::sqrt(scene.youngs_modulus / scene.density) / scene.spacing;
    const auto automatic =
        scene.step || scene.cfl ? AutomaticStep{} : automatic_step(scene, lattice, omega_max);
    const double time_step =
        scene.step ? *scene.step : 2 * scene.cfl.value_or(automatic.cfl) / omega_max;
    require_matched(scene, time_step);
    const double cfl = time_step * omega_max / 2;
    const double limit = nmbc::interior_cfl(lattice);
    if (cfl > limit) {
        throw SceneError(fmt::format(
            "{}: cfl = {:.4g} is above the interior's limit of {:.4g}, a step of {:.6g}",
            scene.step ? "time.step" : "time.cfl", cfl, limit, 2 * limit / omega_max));
    }
    Plan plan{.time_step = time_step,
              .steps = steps_until(scene.end, time_step),
              .cfl = cfl,
              .limit = automatic.limit};
    plan.objection =
        objection(scene, table_of(scene, scene.left), table_of(scene, scene.right), time_step, cfl);
    if (!plan.objection.empty() && !scene.allow_unstable) {
        throw Unstable(
            plan.objection +
            (has_certificate(scene.left.kind) && has_certificate(scene.right.kind)
                 ? ". Try a smaller time step, another G, order or stride (windows: "
                   "docs/stability.md), or run it all the same: boundary.allow_unstable = true"
                 : ". To run it all the same: boundary.allow_unstable = true"));
    }
    return plan;
}

}  // namespace

Simulation::Simulation(const Scene& scene)
    : Simulation(scene, nmbc::make_lattice(table_of(scene, scene.left), scene.G),
                 chain_end(scene, scene.left), chain_end(scene, scene.right)) {}

// The ends come first: what does not exist has no certificate.
Simulation::Simulation(const Scene& scene, nmbc::Lattice lattice, const nmbc::ChainEnd& left,
                       const nmbc::ChainEnd& right)
    : scene_(scene),
      plan_(plan_of(scene, lattice)),
      chain_(std::move(lattice), left, right,
             {.nodes = scene.nodes,
              .spacing = scene.spacing,
              .youngs_modulus = scene.youngs_modulus,
              .density = scene.density,
              .time_step = plan_.time_step}),
      driver_(scene, chain_.first_interior(), plan_.time_step) {}

}  // namespace nmbcrun
