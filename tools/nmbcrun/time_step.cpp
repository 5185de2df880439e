// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/time_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nmbc/certificate.hpp>
#include <nmbc/tables/tables.hpp>

#include "tools/nmbcrun/certificate.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/tables.hpp"

namespace nmbcrun {
namespace {

constexpr const char* to_try_one =
    "To try one, give time.step or time.cfl, and boundary.allow_unstable = true";

/// The least of what each end's table is certified for with its like.
AutomaticStep certified_with_their_like(const Scene& scene, const nmbc::Lattice& lattice) {
    // Fixed and free ends by themselves: just below the interior's own limit.
    AutomaticStep step{0.99 * nmbc::interior_cfl(lattice), "just below the interior's limit"};
    for (const Boundary* boundary : {&scene.left, &scene.right}) {
        if (boundary->kind != BoundaryKind::nmbc) {
            continue;
        }
        const nmbc::MatchingTable& table = table_of(scene, *boundary);
        const double cfl = nmbc::certified_cfl(table, scene.G, boundary->ghosts);
        if (cfl == 0) {
            throw Unstable(fmt::format(
                "no time step is certified for {} at G = {}: {}. {}", heading_of(*boundary),
                scene.G, nmbc::certified_choices(table, scene.G, nmbc::generated::tables),
                to_try_one));
        }
        if (cfl < step.cfl) {
            step = {cfl, "the largest certified for " + heading_of(*boundary)};
        }
    }
    return step;
}

}  // namespace

AutomaticStep automatic_step(const Scene& scene, const nmbc::Lattice& lattice, double omega_max) {
    AutomaticStep step = certified_with_their_like(scene, lattice);
    constexpr double steps_of_drive = 20;
    const double of_drive = scene.drive.duration / steps_of_drive * omega_max / 2;
    if (of_drive < step.cfl) {
        step = {of_drive, "a twentieth of drive.duration"};
    }
    if (scene.left == scene.right) {
        return step;
    }
    const nmbc::MatchingTable& left = table_of(scene, scene.left);
    const nmbc::MatchingTable& right = table_of(scene, scene.right);
    std::string problem = objection(scene, left, right, 2 * step.cfl / omega_max, step.cfl);
    while (!problem.empty()) {
        constexpr double less = 0.05;
        constexpr double least = 0.01;  // that tables are certified for
        step = {step.cfl - less, "the largest certified for this pair of ends, to 0.05 of cfl"};
        if (step.cfl < least) {
            throw Unstable(fmt::format("no time step is certified for this pair of ends: {}. {}",
                                       problem, to_try_one));
        }
        problem = objection(scene, left, right, 2 * step.cfl / omega_max, step.cfl);
    }
    return step;
}

}  // namespace nmbcrun
