// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/step_warnings.hpp"
#include "tools/nmbcrun/output/warnings.hpp"
#include "tools/nmbcrun/plane/finer_run.hpp"
#include "tools/nmbcrun/plane/plane_plan.hpp"
#include "tools/nmbcrun/plane/plane_report.hpp"
#include "tools/nmbcrun/plane/plane_run.hpp"
#include "tools/nmbcrun/plane/plane_sides.hpp"
#include "tools/nmbcrun/plane/plane_simulation.hpp"
#include "tools/nmbcrun/plane/same_body.hpp"
#include "tools/nmbcrun/terminal/interrupt.hpp"
#include "tools/nmbcrun/terminal/progress.hpp"

namespace nmbcrun {
namespace {

/// In the scene's own steps and on its lattice, without artificial sides.
ReferenceRun endless_run(PlaneScene scene, double time_step, bool quiet) {
    scene.sides = without_artificial(scene.sides);
    scene.step = time_step;
    scene.cfl.reset();
    return {.simulation = PlaneSimulation(scene, quiet)};
}

/// The largest displacement of the reference so far, and of what differs from it.
struct Comparison {
    double largest = 0;
    double error = 0;
    std::array<std::ptrdiff_t, 2> where{};  ///< node, from 1
    double when = 0;

    /// Throws Unstable where one of both is not finite.
    void look(const CommonNodes::Difference& now, double time) {
        if (!std::isfinite(now.largest)) {
            throw Unstable(
                fmt::format("u is not finite at node ({}, {}), t = {:.4g}, or that of "
                            "the reference is not",
                            now.node[0], now.node[1], time));
        }
        largest = std::max(largest, now.other);
        if (now.largest > error) {
            error = now.largest;
            where = now.node;
            when = time;
        }
    }
};

}  // namespace

bool verify_plane(const PlaneScene& scene, double tolerance, bool finer, bool quiet) {
    const bool is_finer =
        finer || std::ranges::none_of(scene.sides, [](const PlaneSideChoice& side) {
            return is_artificial(side.kind);
        });
    const nmbc::PlaneSides sides = sides_of(scene, quiet).all;
    std::optional<SameBody> body;  // before what takes memory
    if (is_finer) {
        body = finer_body(scene, sides);
    }
    PlaneSimulation simulation(scene, sides);
    const double time_step = simulation.plan().time_step;
    ReferenceRun reference =
        body ? finer_run(std::move(*body), time_step) : endless_run(scene, time_step, quiet);
    const CommonNodes nodes(simulation, reference.simulation);
    const auto nodes_of = [](const PlaneSimulation& one) {
        return one.plane().grid().nx * one.plane().grid().ny;
    };
    const PlanePlan& plan = simulation.plan();
    const StepsLeft all{plan.steps,
                        nodes_of(simulation) + reference.steps * nodes_of(reference.simulation),
                        pace_of(scene)};
    require_bearable_length(plan, unit_of_time(scene), all);
    print_warnings(warnings_of(simulation));
    print_warnings(warnings_of_steps(plan, unit_of_time(scene), all));
    if (!quiet) {
        fmt::print("{}time      {} steps of {}\nreference{}\n{}\n", heading_of(simulation),
                   simulation.plan().steps, heading_of(simulation.plan()),
                   is_finer ? fmt::format(" the same body, nodes dX/{} apart, {} steps to one",
                                          reference.ratio, reference.steps)
                            : "",
                   heading_of(reference.simulation));
        std::fflush(stdout);  // through a pipe, too, it is read before the runs
    }
    note_interrupts();
    constexpr std::size_t peak_every = 10;  // steps
    Progress progress(simulation.plan().steps, quiet);
    Comparison found;
    double peak = simulation.energies().total();
    double reference_peak = reference.simulation.energies().total();
    while (!simulation.is_done()) {
        simulation.advance(1);
        reference.advance();
        found.look(nodes.between(simulation, reference.simulation), simulation.plane().time());
        if (simulation.plane().steps() % peak_every == 0 || simulation.is_done()) {
            peak = std::max(peak, simulation.energies().total());
            reference_peak = std::max(reference_peak, reference.simulation.energies().total());
        }
        progress.update(simulation.plane().steps());
        if (interrupted()) {
            throw Interrupted(fmt::format("stopped at step {} of {}", simulation.plane().steps(),
                                          simulation.plan().steps));
        }
    }
    if (!(found.largest > 0)) {
        throw nothing_to_compare_with();
    }
    const double error = found.error / found.largest;
    const bool holds = error <= tolerance;
    fmt::print(
        "error        {:.3e} in amplitude, of max |u|, at node ({}, {}), t = {:.4g}; {} the "
        "tolerance {:g}\n",
        error, found.where[0], found.where[1], found.when, holds ? "within" : "above", tolerance);
    if (peak > 0 && reference_peak > 0) {
        const bool is_driven = simulation.is_driven(simulation.plane().time());
        fmt::print("{:<12} {:.3e} of the peak; {} {:.3e}\n",
                   is_driven ? "energy then" : "energy left", simulation.energies().total() / peak,
                   is_finer ? "of the reference" : "without artificial sides",
                   reference.simulation.energies().total() / reference_peak);
    }
    return holds;
}

}  // namespace nmbcrun
