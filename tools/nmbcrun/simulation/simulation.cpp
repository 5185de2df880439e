// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/simulation/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nmbc/lattice.hpp>

#include "tools/nmbcrun/certification/certificate.hpp"
#include "tools/nmbcrun/certification/stand_ins.hpp"
#include "tools/nmbcrun/certification/time_step.hpp"
#include "tools/nmbcrun/ends/passive_design.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/simulation/ends.hpp"
#include "tools/nmbcrun/simulation/memory.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

// Compiled for wide vectors, too, which are used where the processor has them: the same operations
// in the same order, and none of them fused, so that the digits are the same.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define NMBCRUN_WIDE_VECTORS [[gnu::target_clones("avx2", "default"), gnu::flatten]]
#else
#define NMBCRUN_WIDE_VECTORS
#endif

namespace nmbcrun {
namespace {

/// The other ends say for themselves what they need, when they are made.
void require_room(const Scene& scene) {
    for (const Boundary* boundary : {&scene.left, &scene.right}) {
        const auto least = std::size_t(boundary->order) * std::size_t(boundary->stride);
        if (takes_table(boundary->kind) && scene.nodes < least) {
            throw SceneError(fmt::format("domain.nodes is {}, but {} needs at least {}",
                                         scene.nodes, heading_of(*boundary), least));
        }
    }
}

Plan plan_of(const Scene& scene, const nmbc::Lattice& lattice) {
    require_room(scene);
    const double omega_max = highest_frequency(scene, lattice);
    const SurfaceLimits surfaces = surface_limits(scene, lattice);
    const auto automatic = scene.step || scene.cfl
                               ? AutomaticStep{}
                               : automatic_step(scene, lattice, omega_max, surfaces);
    const double time_step =
        scene.step ? *scene.step : 2 * scene.cfl.value_or(automatic.cfl) / omega_max;
    require_matched(scene, time_step);
    const double cfl = time_step * omega_max / 2;
    if (const std::string problem =
            objection_to_steps(scene, lattice, time_step, surfaces,
                               scene.allow_unstable ? OfEnds::any : OfEnds::certified);
        !problem.empty()) {
        throw Unstable(problem);
    }
    Plan plan{{.time_step = time_step,
               .steps = steps_until(scene.end, time_step),
               .cfl = cfl,
               .limit = automatic.limit}};
    require_memory(scene, lattice, time_step);
    plan.objection = PairOfEnds(scene, table_of(scene, scene.left), table_of(scene, scene.right))
                         .objection(time_step, cfl);
    if (!plan.objection.empty() && !scene.allow_unstable) {
        const bool has_choice =
            has_certificate(scene.left.kind) && has_certificate(scene.right.kind);
        throw Unstable(fmt::format(
            "{}{}{}.\nTo run it all the same: boundary.allow_unstable = true", plan.objection,
            has_choice ? ".\n" : "", has_choice ? what_is_certified(scene, lattice) : ""));
    }
    return plan;
}

/// Where there is no design no table helps, so that none is asked for.
void require_designs(const Scene& scene) {
    const bool is_passive =
        scene.left.kind == BoundaryKind::passive || scene.right.kind == BoundaryKind::passive;
    if (const std::string why_not = is_passive ? why_not_designed(scene) : ""; !why_not.empty()) {
        throw SceneError("passive ends are " + why_not);
    }
}

nmbc::Lattice lattice_with_designs(const Scene& scene) {
    require_designs(scene);
    return nmbc::make_lattice(table_of(scene, scene.left), scene.G);
}

nmbc::ChainEnd end_without_pole(const Scene& scene, const Boundary& boundary) {
    require_designs(scene);
    require_no_pole(scene, boundary);
    return chain_end(scene, boundary);
}

}  // namespace

Simulation::Simulation(const Scene& scene)
    : Simulation(scene, lattice_with_designs(scene), end_without_pole(scene, scene.left),
                 end_without_pole(scene, scene.right)) {}

// The ends come first: what does not exist has no certificate.
Simulation::Simulation(const Scene& scene, nmbc::Lattice lattice, const nmbc::ChainEnd& left,
                       const nmbc::ChainEnd& right)
    : scene_(scene),
      plan_(plan_of(scene, lattice)),
      sources_(scene, lattice, parameters_of(scene, plan_.time_step), plan_.steps),
      chain_(std::move(lattice), sources_.end(nmbc::End::left, left),
             sources_.end(nmbc::End::right, right), parameters_of(scene, plan_.time_step)) {
    sources_.start(chain_);
}

NMBCRUN_WIDE_VECTORS nmbc::Energies Simulation::energies() const {
    return nmbc::energies(chain_);
}

}  // namespace nmbcrun
