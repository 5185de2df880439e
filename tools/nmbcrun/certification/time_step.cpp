// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/certification/time_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nmbc/certificate.hpp>
#include <optional>

#include "tools/nmbcrun/certification/certificate.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/sides/half_line.hpp"
#include "tools/nmbcrun/sources/time_scale.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun {
namespace {

constexpr const char* to_try_its_own = "To try it, give boundary.allow_unstable = true";
constexpr const char* to_try_one =
    "To try one, give time.step or time.cfl, and boundary.allow_unstable = true";

bool is_matched(const Boundary& boundary) {
    return takes_table(boundary.kind) && boundary.matched_step != "0";
}

/// The least of what each end's table is certified for with its like, where anything comes back
/// from the other end.
AutomaticStep certified_with_their_like(const Scene& scene, const nmbc::Lattice& lattice) {
    // Fixed and free ends by themselves: just below the interior's own limit.
    AutomaticStep step{0.99 * nmbc::interior_cfl(lattice), "just below the interior's limit"};
    for (const Boundary* boundary : {&scene.left, &scene.right}) {
        if (!has_certificate(boundary->kind)) {
            throw Unstable(
                fmt::format("no time step is certified for an end that is {}: there is "
                            "no certificate for this kind. {}",
                            heading_of(*boundary), to_try_one));
        }
        const Boundary& opposite = boundary == &scene.left ? scene.right : scene.left;
        const double time_step = 2 * step.cfl / nmbc::maximum_frequency(lattice);
        if (!takes_table(boundary->kind) || is_half_line(scene, opposite, lattice, time_step)) {
            continue;
        }
        const nmbc::MatchingTable& table = table_of(scene, *boundary);
        const double cfl = nmbc::certified_cfl(table, scene.G, boundary->ghosts);
        if (cfl == 0) {
            const TableFile* uncertified = uncertified_file(scene, table);
            throw Unstable(fmt::format(
                "no time step is certified for {} at G = {}: {}{}{}. {}", heading_of(*boundary),
                scene.G,
                uncertified == nullptr ? ""
                                       : fmt::format("its table, in {}, was written with "
                                                     "--uncertified; ",
                                                     uncertified->name()),
                boundary->ghosts == nmbc::GhostRule::midpoint ? "" : "with midpoint ghosts, ",
                nmbc::certified_choices(table, scene.G, tables_of(scene)),
                is_matched(*boundary) ? to_try_its_own : to_try_one));
        }
        if (cfl < step.cfl) {
            step = {cfl, "the largest certified for " + heading_of(*boundary)};
        }
    }
    return step;
}

double matched_time_step(const Boundary& boundary) {
    return nmbc::detail::nearest_to_fraction(boundary.matched_step);
}

void require_midpoint_ghosts(const Boundary& boundary) {
    if (boundary.ghosts != nmbc::GhostRule::midpoint) {
        throw SceneError("a boundary that is matched in time steps needs midpoint ghosts");
    }
}

/// The step that an end is matched in, if there is one.
std::optional<AutomaticStep> matched_step(const Scene& scene, const nmbc::Lattice& lattice) {
    for (const Boundary* boundary : {&scene.left, &scene.right}) {
        if (is_matched(*boundary)) {
            require_midpoint_ghosts(*boundary);
            return AutomaticStep{
                matched_time_step(*boundary) * nmbc::maximum_frequency(lattice) / 2,
                "what the boundary is matched in"};
        }
    }
    return std::nullopt;
}

}  // namespace

double highest_frequency(const Scene& scene, const nmbc::Lattice& lattice) {
    return nmbc::maximum_frequency(lattice) * wave_speed(scene) / scene.spacing;
}

void require_matched(const Scene& scene, double time_step) {
    const double unit = unit_of_time(scene);
    for (const Boundary* boundary : {&scene.left, &scene.right}) {
        if (!is_matched(*boundary)) {
            continue;
        }
        const double matched = matched_time_step(*boundary) * unit;
        if (std::abs(time_step - matched) > nmbc::time_step_tolerance * matched) {
            throw SceneError(
                fmt::format("the time step is {:.7g}, but {} needs {:.7g}: leave out "
                            "time.step and time.cfl, and match both ends alike",
                            time_step, heading_of(*boundary), matched));
        }
        require_midpoint_ghosts(*boundary);
    }
}

std::size_t steps_until(double end, double time_step) {
    const double exact_steps = end / time_step;
    if (!std::isfinite(exact_steps)) {
        throw SceneError(
            fmt::format("time.end = {:g} is too long for time steps of {:g}, which domain.spacing, "
                        "the material "
                        "or time.step and time.cfl ask for",
                        end, time_step));
    }
    if (exact_steps > 1e15) {
        throw SceneError(fmt::format("time.end asks for {:.3g} steps; at most 1e15", exact_steps));
    }
    // A last step that is a millionth of a step is a rounding of time.end / dt.
    return std::size_t(std::max(1.0, std::ceil(exact_steps - 1e-6)));
}

AutomaticStep automatic_step(const Scene& scene, const nmbc::Lattice& lattice, double omega_max) {
    const auto matched = matched_step(scene, lattice);
    if (matched && scene.allow_unstable) {
        return *matched;
    }
    AutomaticStep step = certified_with_their_like(scene, lattice);
    if (matched && matched->cfl > step.cfl) {
        throw Unstable(
            fmt::format("the boundary is matched in steps of cfl {:.3f}, and {:.3f} is {}. {}",
                        matched->cfl, step.cfl, step.limit, to_try_its_own));
    }
    step = matched.value_or(step);
    constexpr double steps_of_drive = 20;
    const TimeScale scale = shortest_time_scale(scene, lattice);
    const double of_drive = scale.time / steps_of_drive * omega_max / 2;
    if (!matched && of_drive < step.cfl) {
        step = {of_drive, "a twentieth of " + scale.name};
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
        if (step.cfl < least || matched) {
            throw Unstable(fmt::format("no time step is certified for this pair of ends: {}. {}",
                                       problem, matched ? to_try_its_own : to_try_one));
        }
        problem = objection(scene, left, right, 2 * step.cfl / omega_max, step.cfl);
    }
    return step;
}

}  // namespace nmbcrun
