// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/interrupt.hpp"
#include "tools/nmbcrun/output/progress.hpp"
#include "tools/nmbcrun/output/warnings.hpp"
#include "tools/nmbcrun/plane/plane_report.hpp"
#include "tools/nmbcrun/plane/plane_run.hpp"
#include "tools/nmbcrun/plane/plane_simulation.hpp"

namespace nmbcrun {
namespace {

/// The scene with sides in the place of its artificial ones that are so far off that nothing
/// returns.
PlaneScene without_artificial_sides(PlaneScene scene) {
    for (PlaneSideChoice& side : scene.sides) {
        if (is_artificial(side.kind)) {
            side = {.kind = SideKind::extended, .layer = 0};
        }
    }
    return scene;
}

/// The largest displacement of the reference so far, and of what differs from it.
struct Comparison {
    double largest = 0;
    double error = 0;
    std::array<std::size_t, 2> where{};  ///< node, from 1
    double when = 0;

    void look(const PlaneSimulation& simulation, const PlaneSimulation& reference,
              const std::array<std::size_t, 2>& nodes) {
        for (std::size_t y = 0; y < nodes[1]; ++y) {
            for (std::size_t x = 0; x < nodes[0]; ++x) {
                for (const std::size_t a : {0U, 1U}) {
                    const double u = simulation.plane().displacement(a)[simulation.entry(x, y)];
                    const double there = reference.plane().displacement(a)[reference.entry(x, y)];
                    largest = std::max(largest, std::abs(there));
                    if (!(std::abs(u - there) <= error)) {
                        error = std::abs(u - there);
                        where = {x + 1, y + 1};
                        when = simulation.plane().time();
                    }
                }
            }
        }
    }
};

}  // namespace

bool verify_plane(const PlaneScene& scene, double tolerance, bool quiet) {
    if (std::ranges::none_of(
            scene.sides, [](const PlaneSideChoice& side) { return is_artificial(side.kind); })) {
        throw SceneError(
            "all sides are physical, fixed, free, sbp, kernel, mirror or periodic, and verify "
            "looks "
            "at what artificial ones do: there is none");
    }
    PlaneSimulation simulation(scene, quiet);
    PlaneScene endless = without_artificial_sides(scene);
    endless.step = simulation.plan().time_step;
    endless.cfl.reset();
    PlaneSimulation reference(endless, quiet);
    print_warnings(warnings_of(simulation));
    if (!quiet) {
        fmt::print("{}time      {} steps of {}\nreference\n{}\n", heading_of(simulation),
                   simulation.plan().steps, heading_of(simulation.plan()), heading_of(reference));
    }
    note_interrupts();
    constexpr std::size_t peak_every = 10;  // steps
    Progress progress(simulation.plan().steps, quiet);
    Comparison found;
    double peak = reference.energies().total();
    while (!simulation.is_done()) {
        simulation.advance(1);
        reference.advance(1);
        found.look(simulation, reference, scene.nodes);
        if (simulation.plane().steps() % peak_every == 0) {
            peak = std::max(peak, reference.energies().total());
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
    if (peak > 0) {
        const bool is_driven = simulation.is_driven(simulation.plane().time());
        fmt::print("{:<12} {:.3e} of the peak; without artificial sides {:.3e}\n",
                   is_driven ? "energy then" : "energy left", simulation.energies().total() / peak,
                   reference.energies().total() / peak);
    }
    return holds;
}

}  // namespace nmbcrun
