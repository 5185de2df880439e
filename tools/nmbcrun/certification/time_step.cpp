// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/certification/time_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nmbc/boundary.hpp>
#include <nmbc/certificate.hpp>
#include <nmbc/surface.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "generator/exact/rounded_text.hpp"
#include "tools/nmbcrun/certification/certificate.hpp"
#include "tools/nmbcrun/certification/stand_ins.hpp"
#include "tools/nmbcrun/ends/half_line.hpp"
#include "tools/nmbcrun/ends/passive_design.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/sources/time_scale.hpp"
#include "tools/nmbcrun/tables/tables.hpp"
#include "tools/nmbcrun/terminal/interrupt.hpp"

namespace nmbcrun {
namespace {

constexpr const char* to_try_its_own = "To try it, give boundary.allow_unstable = true";
constexpr const char* to_try_one =
    "To try one, give time.step or time.cfl, and boundary.allow_unstable = true";

bool is_matched(const Boundary& boundary) {
    return takes_table(boundary.kind) && boundary.matched_step != "0";
}

void shorten(AutomaticStep& step, double cfl, std::string limit) {
    if (cfl < step.cfl) {
        step.cfl = cfl;
        step.limit = std::move(limit);
    }
}

/// Of the fastest mode beside a true end, or of the interior: omega_max over its frequency.
double surface_cfl(const Scene& scene, const Boundary& boundary, const nmbc::Lattice& lattice) {
    constexpr double rounding = 1e-9;  // of the largest eigenvalue
    try {
        return (1 - rounding) * nmbc::maximum_frequency(lattice) /
               std::sqrt(nmbc::largest_eigenvalue(lattice, closure_of(boundary.kind),
                                                  boundary.given, scene.nodes));
    } catch (const std::invalid_argument& error) {
        throw SceneError(fmt::format(R"(boundary.kind = "{}": {}; "mirror" ends any lattice)",
                                     name_of(boundary.kind), error.what()));
    }
}

std::string why_uncertified(const Scene& scene, const Boundary& boundary) {
    const nmbc::MatchingTable& table = table_of(scene, boundary);
    const TableFile* uncertified = uncertified_file(scene, table);
    return fmt::format("{} at G = {}: {}{}{}", heading_of(boundary), scene.G,
                       uncertified == nullptr
                           ? ""
                           : fmt::format("its table, in {}, was written with --uncertified; ",
                                         uncertified->name()),
                       boundary.ghosts == nmbc::GhostRule::midpoint ? "" : "with midpoint ghosts, ",
                       nmbc::certified_choices(table, scene.G, tables_of(scene)));
}

/// The least of what each end's table is certified for with its like, where anything comes back
/// from the other end. cfl = 0: nothing is, for the reason in `limit`.
AutomaticStep with_their_like(const Scene& scene, const nmbc::Lattice& lattice,
                              const SurfaceLimits& surfaces) {
    // Fixed and free ends by themselves: just below the interior's own limit.
    AutomaticStep step{0.99 * nmbc::interior_cfl(lattice), "just below the interior's limit"};
    for (const Boundary* boundary : {&scene.left, &scene.right}) {
        if (!has_certificate(boundary->kind)) {
            return {0, fmt::format("an end that is {}: there is no certificate for this kind",
                                   heading_of(*boundary))};
        }
        if (boundary->kind == BoundaryKind::passive) {
            shorten(step, DesignedEnd::largest_cfl, "what passive ends are designed for");
        }
        if (is_closure(boundary->kind)) {
            shorten(step, boundary == &scene.left ? surfaces.left : surfaces.right,
                    boundary->kind == BoundaryKind::snm
                        ? "what a surface node allows"
                        : fmt::format("what a \"{}\" end allows", name_of(boundary->kind)));
        }
        const Boundary& opposite = boundary == &scene.left ? scene.right : scene.left;
        const double time_step = 2 * step.cfl / nmbc::maximum_frequency(lattice);
        if (!takes_table(boundary->kind) || is_half_line(scene, opposite, lattice, time_step)) {
            continue;
        }
        const auto steps = boundary->ghosts == nmbc::GhostRule::midpoint
                               ? nmbc::certified_steps(table_of(scene, *boundary), scene.G)
                               : nmbc::StableStep{{}, 0};
        if (steps.cfl == 0) {
            return {0, why_uncertified(scene, *boundary)};
        }
        step.from = std::max(step.from, steps.from);
        shorten(step, steps.cfl, "the largest certified for " + heading_of(*boundary));
    }
    return step;
}

/// The first of cfl, cfl - 0.05, .. at which the two ends are certified together; cfl = 0: at none,
/// and `limit` says why not at the first.
AutomaticStep certified_together(const Scene& scene, const AutomaticStep& longest,
                                 double omega_max) {
    constexpr double less = 0.05;
    const double least = std::min(longest.cfl, std::max(0.01, longest.from));
    PairOfEnds pair(scene, table_of(scene, scene.left), table_of(scene, scene.right));
    AutomaticStep step = longest;
    std::string first_problem;
    for (; step.cfl > 0 && step.cfl >= least; step.cfl -= less) {
        stop_if_interrupted();  // of a damped chain each step takes a good part of a second
        const std::string problem = pair.objection(2 * step.cfl / omega_max, step.cfl);
        if (problem.empty()) {
            return step;
        }
        first_problem = first_problem.empty() ? problem : first_problem;
        step.limit = "the largest certified for this pair of ends, to 0.05 of cfl";
    }
    return {0, first_problem};
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
                "what the boundary is matched in", 0};
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

SurfaceLimits surface_limits(const Scene& scene, const nmbc::Lattice& lattice) {
    const auto limit = [&](const Boundary& boundary) {
        return is_closure(boundary.kind) ? surface_cfl(scene, boundary, lattice)
                                         : nmbc::interior_cfl(lattice);
    };
    const double left = limit(scene.left);
    return {left, scene.left == scene.right ? left : limit(scene.right)};
}

std::string objection_to_steps(const Scene& scene, const nmbc::Lattice& lattice, double time_step,
                               const SurfaceLimits& surfaces, OfEnds of_ends) {
    const double omega_max = highest_frequency(scene, lattice);
    const double cfl = time_step * omega_max / 2;
    constexpr double roundings = 1e-12;  // the limit was a time step on its way here
    const double beside = surfaces.least() * (1 + roundings);
    const double stable = std::min(nmbc::interior_cfl(lattice), beside);
    if (cfl <= stable) {
        return "";
    }
    const bool has_table = takes_table(scene.left.kind) || takes_table(scene.right.kind);
    const double certified = has_table && of_ends == OfEnds::certified
                                 ? std::min(stable, largest_certified_cfl(scene, lattice))
                                 : stable;
    const double allowed = certified > 0 ? certified : stable;
    const std::string longest = nmbcgen::rounded_down(2 * allowed / omega_max, 6);
    const std::string largest = nmbcgen::rounded_down(allowed, 3);
    const bool is_limit = allowed >= stable * (1 - 2 * roundings);  // with or without them
    // Else shorter ones need not be certified, and some longer ones may be.
    const std::string choice =
        is_limit ? fmt::format("between these ends steps up to {} (cfl = {}) are stable", longest,
                               largest)
                 : fmt::format(
                       "these ends are certified in steps of {} (cfl = {}), "
                       "and none above cfl = {} is stable",
                       longest, largest, nmbcgen::rounded_up(stable, 3));
    const char* or_less = is_limit ? " or less" : "";
    return fmt::format("steps of {:.6g} (cfl = {:.3g}) are too long: {}{}", time_step, cfl, choice,
                       certified == 0 ? ", and none is certified"
                       : scene.step   ? fmt::format(". Give time.step = {}{}", longest, or_less)
                       : scene.cfl    ? fmt::format(". Give time.cfl = {}{}", largest, or_less)
                                      : "");
}

AutomaticStep automatic_step(const Scene& scene, const nmbc::Lattice& lattice, double omega_max,
                             const SurfaceLimits& surfaces) {
    const auto matched = matched_step(scene, lattice);
    if (matched && scene.allow_unstable) {
        return *matched;
    }
    AutomaticStep step = with_their_like(scene, lattice, surfaces);
    if (step.cfl == 0) {
        const std::string choices = choices_in_place(scene);
        throw Unstable(fmt::format("no time step is certified for {}.{}\n{}", step.limit,
                                   choices.empty() ? "" : "\n" + choices + ".",
                                   matched ? to_try_its_own : to_try_one));
    }
    constexpr double roundings = 1e-9;
    if (matched && matched->cfl > step.cfl * (1 + roundings)) {
        throw Unstable(
            fmt::format("the boundary is matched in steps of cfl {:.3f}, and {:.3f} is {}.\n{}",
                        matched->cfl, step.cfl, step.limit, to_try_its_own));
    }
    step = matched.value_or(step);
    constexpr double steps_of_drive = 20;
    const TimeScale scale = shortest_time_scale(scene, lattice);
    const double of_drive = scale.time / steps_of_drive * omega_max / 2;
    if (!matched && of_drive < step.cfl) {
        step.cfl = std::max(of_drive, step.from);
        step.limit = of_drive < step.from ? "the smallest certified for these ends"
                                          : "a twentieth of " + scale.name;
    }
    if (scene.left == scene.right) {
        return step;
    }
    AutomaticStep together = certified_together(scene, step, omega_max);
    if (together.cfl == 0 || (matched && together.cfl < step.cfl)) {
        throw Unstable(fmt::format("no time step is certified for this pair of ends: {}.\n{}.\n{}",
                                   matched ? "not the one that it is matched in" : together.limit,
                                   what_is_certified(scene, lattice),
                                   matched ? to_try_its_own : to_try_one));
    }
    return together;
}

double largest_certified_cfl(const Scene& scene, const nmbc::Lattice& lattice) {
    const AutomaticStep step = with_their_like(scene, lattice, surface_limits(scene, lattice));
    return scene.left == scene.right
               ? step.cfl
               : certified_together(scene, step, highest_frequency(scene, lattice)).cfl;
}

}  // namespace nmbcrun
