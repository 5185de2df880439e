// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/advise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "generator/support/progress_line.hpp"
#include "tools/nmbcrun/advise/search.hpp"
#include "tools/nmbcrun/chart/cost.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/first_steps.hpp"
#include "tools/nmbcrun/output/warnings.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"
#include "tools/nmbcrun/terminal/duration.hpp"
#include "tools/nmbcrun/terminal/stopwatch.hpp"

namespace nmbcrun {
namespace {

/// The scene as advised: lattice, boundaries and time step.
Scene advised(const Scene& scene, const Candidate& candidate) {
    Scene result = with_artificial_ends(with_lattice(scene, candidate.horizon, candidate.G),
                                        candidate.boundary);
    result.allow_unstable = false;
    result.allow_amplifying = false;
    if (!scene.step && !scene.cfl && candidate.boundary.matched_step == "0") {
        result.cfl = candidate.cfl;
    }
    return result;
}

/// What the keys of its artificial ends begin with: both share theirs, unless one is physical or a
/// key of its own.
std::vector<std::string> groups_of_ends(const Scene& scene) {
    const bool each_its_own = std::ranges::any_of(scene.given, [](const auto& key_and_value) {
        return key_and_value.first.starts_with("boundary.left.") ||
               key_and_value.first.starts_with("boundary.right.");
    });
    std::vector<std::string> groups;
    for (const auto& [end, name] :
         {std::pair(&scene.left, "boundary.left"), {&scene.right, "boundary.right"}}) {
        if (!is_physical(end->kind)) {
            groups.emplace_back(name);
        }
    }
    return groups.size() == 2 && !each_its_own ? std::vector<std::string>{"boundary"} : groups;
}

/// The settings that make a scene the advised one, as --set takes them.
std::string settings_of(const Scene& scene, const Candidate& candidate) {
    const Boundary& boundary = candidate.boundary;
    std::string settings;
    if (scene.auto_horizon) {
        settings += fmt::format("--set model.horizon={} ", candidate.horizon);
    }
    if (scene.auto_G) {
        settings += fmt::format("--set model.G={} ", candidate.G);
    }
    for (const std::string& group : groups_of_ends(scene)) {
        const auto set = [&](const char* key, const auto& value) {
            settings += fmt::format("--set {}.{}={} ", group, key, value);
        };
        set("kind", name_of(boundary.kind));
        if (boundary.kind == BoundaryKind::nmbc) {
            set("order", boundary.order);
            set("stride", boundary.stride);
            const Boundary& own = group == "boundary.right" ? scene.right : scene.left;
            if (own.ghosts != boundary.ghosts) {
                set("ghosts", "midpoint");
            }
            if (own.matched_step != boundary.matched_step) {
                set("matched_step", boundary.matched_step);
            }
        }
    }
    if (boundary.matched_step != "0") {
        settings.pop_back();
        return settings;
    }
    constexpr double digits = 1e4;  // rounded down: what is certified has an end above
    return settings + fmt::format("--set time.cfl={}", std::floor(candidate.cfl * digits) / digits);
}

void measure_costs(const Scene& scene, std::vector<Candidate>& candidates, const Pause& pause) {
    std::vector<Scene> scenes;
    scenes.reserve(candidates.size());
    for (const Candidate& candidate : candidates) {
        scenes.push_back(advised(scene, candidate));
        scenes.back().step = candidate.time_step;
    }
    constexpr std::size_t rounds = 31;  // the medians are good to a few per cent
    const auto costs = relative_costs(
        scenes, [] {}, pause, rounds);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        candidates[i].cost = costs[i].of_run(candidates[i].steps);
    }
}

/// What a boundary reads: the smaller, the simpler.
std::size_t size_of(const Candidate& candidate) {
    switch (candidate.boundary.kind) {
        case BoundaryKind::fixed:
            return 0;
        case BoundaryKind::nmbc:
            return std::size_t(candidate.boundary.order) * std::size_t(candidate.boundary.stride);
        case BoundaryKind::passive:
            return 7 * std::size_t(candidate.horizon);  // nodes it adds
        default:
            return candidate.steps;  // of history, or as many nodes
    }
}

/// By cost, but among those that cannot be told from the cheapest the simplest comes first.
void rank(std::vector<Candidate>& candidates) {
    std::ranges::sort(candidates, {}, &Candidate::cost);
    constexpr double told_apart = 1.05;
    const double alike = told_apart * candidates.front().cost;
    const auto end = std::ranges::find_if(
        candidates, [alike](const Candidate& one) { return one.cost > alike; });
    std::stable_sort(candidates.begin(), end, [](const Candidate& one, const Candidate& other) {
        return size_of(one) < size_of(other);
    });
}

/// Of many candidates with open lattices those worth a measurement: of each horizon and kind of end
/// the few that take the fewest steps, the simplest first among equals.
std::vector<Candidate> worth_measuring(std::vector<Candidate> candidates) {
    std::ranges::sort(candidates, {},
                      [](const Candidate& one) { return std::tuple(one.steps, size_of(one)); });
    std::map<std::pair<int, BoundaryKind>, int> so_far;
    std::erase_if(candidates, [&](const Candidate& one) {
        const int most = one.boundary.kind == BoundaryKind::nmbc ? 4 : 1;
        return ++so_far[{one.horizon, one.boundary.kind}] > most;
    });
    // Steps are measured beside those of the first one's interior: the fastest.
    std::ranges::stable_sort(candidates, {}, &Candidate::horizon);
    return candidates;
}

/// An exact end remembers the whole run: to measure it takes as long, and never pays where a ghost
/// rule will do.
void leave_out_exact(Candidates& candidates) {
    const auto is_exact = [](const Candidate& one) {
        return one.boundary.kind == BoundaryKind::exact;
    };
    const bool is_needed = std::ranges::none_of(candidates.meet, [](const Candidate& one) {
        return one.boundary.kind != BoundaryKind::exact &&
               one.boundary.kind != BoundaryKind::extended;
    });
    if (!is_needed && std::erase_if(candidates.meet, is_exact) > 0) {
        candidates.left_out.push_back(
            {"exact", "it remembers the whole run, and a ghost rule will do"});
    }
}

std::string with_lattice_named(const Scene& scene, const Candidate& one) {
    return has_open_lattice(scene) ? fmt::format("n = {}, G = {}: {}", one.horizon, one.G, one.name)
                                   : one.name;
}

void print_ranked(const Scene& scene, const std::vector<Candidate>& ranked) {
    constexpr std::size_t most_rows = 12;
    const bool open = has_open_lattice(scene);
    const int width = open ? 52 : 36;
    fmt::print("{:<{}}  {:>5}  {:>8}  {:>10}  {:>10}  {:>8}\n", "meets it by prediction", width,
               "cfl", "steps", "ends", open ? "interior" : "time step", "cost");
    for (std::size_t i = 0; i < std::min(ranked.size(), most_rows); ++i) {
        const Candidate& one = ranked[i];
        fmt::print("{:<{}}  {:5.3f}  {:8}  {:10.1e}  {:10.1e}  {:8.2f}\n",
                   with_lattice_named(scene, one), width, one.cfl, one.steps, one.boundary_error,
                   one.interior_error, one.cost / ranked.front().cost);
    }
    fmt::print("cost: time of the run over that of the first, measured now\n\n");
}

/// Of the horizons that meet the tolerance, and are not the advised one: what they cost at least.
void add_dearer_horizons(const std::vector<Candidate>& ranked, std::vector<LeftOut>& left_out) {
    std::set<int> told{ranked.front().horizon};
    for (const Candidate& one : ranked) {
        if (told.insert(one.horizon).second) {
            left_out.push_back({fmt::format("horizon {}", one.horizon),
                                fmt::format("{:.2f} times the cost at least, {} at G = {}",
                                            one.cost / ranked.front().cost, one.name, one.G)});
        }
    }
}

std::string what_meets() {
    return fmt::format("predicted errors times {} have to be within the tolerance", error_margin);
}

void print_left_out(const Scene& scene, const Advice& advice) {
    const auto print = [](const std::string& name, const std::string& reason) {
        fmt::print("  {:<36}  {}\n", name, reason);
    };
    const Candidate& best = advice.ranked.front();
    fmt::print("left out: {}\n", what_meets());
    for (const LeftOut& one : advice.left_out) {
        print(one.name, one.reason);
    }
    print("longer steps", best.why_not_longer);
    if (!scene.step && !scene.cfl) {
        print("shorter steps", "not needed: it meets the tolerance in these");
    }
    if (!scene.field) {
        print("stored fields", "nobody asked for them (output.field)");
    }
    fmt::print("\n");
}

const char* what_counts(const Scene& scene) {
    if (has_open_lattice(scene)) {
        return "of the ends and, against the wave equation, of lattice and time step";
    }
    return scene.step || scene.cfl ? "in the scene's own time step"
                                   : "of the ends and of the time step together";
}

/// About: from the first of its steps.
double seconds_of_run(Simulation& simulation) {
    const std::size_t steps = simulation.plan().steps;
    return double(steps) * take_first_steps(steps, [&] { simulation.step(); }).a_step;
}

std::vector<std::string> uncounted_closures(const Scene& scene) {
    std::vector<std::string> warnings;
    for (const auto& [end, side] : {std::pair(&scene.left, "left"), {&scene.right, "right"}}) {
        if (is_closure(end->kind)) {
            warnings.push_back(fmt::format(
                "what the \"{}\" end on the {} errs is not in the tolerance: nmbcrun verify "
                "measures it",
                name_of(end->kind), side));
        }
    }
    return warnings;
}

/// With a line on stderr meanwhile, unless quiet, and the warnings after it.
Advice announced_advice(const Scene& scene, double tolerance, bool quiet, const Pause& pause) {
    std::optional<nmbcgen::ProgressLine> line;
    if (!quiet) {
        line.emplace("nmbcrun: looking for set-ups");
    }
    Advice advice = advice_for(scene, tolerance, pause);
    line.reset();
    print_warnings(uncounted_closures(scene));
    return advice;
}

}  // namespace

Advice advice_for(const Scene& scene, double tolerance, const Pause& pause) {
    if (has_loaded_surface(scene)) {
        throw SceneError(
            "nothing is advised for a scene with a value on a surface: what the surface sends out "
            "is not predicted. nmbcrun chart measures what the ends do");
    }
    Candidates candidates = find_candidates(scene, tolerance, pause);
    if (candidates.meet.empty()) {
        std::string reasons;
        for (const LeftOut& one : candidates.left_out) {
            reasons += fmt::format("\n  {}: {}", one.name, one.reason);
        }
        throw NotMet(fmt::format("nothing meets the tolerance {:g}; {}:{}", tolerance, what_meets(),
                                 reasons));
    }
    if (has_open_lattice(scene)) {
        candidates.meet = worth_measuring(std::move(candidates.meet));
    }
    leave_out_exact(candidates);
    measure_costs(scene, candidates.meet, pause);
    rank(candidates.meet);
    add_dearer_horizons(candidates.meet, candidates.left_out);
    return {std::move(candidates.meet), std::move(candidates.left_out)};
}

Scene as_advised(const Scene& scene, double tolerance, bool quiet, const Pause& pause) {
    const Candidate best = announced_advice(scene, tolerance, quiet, pause).ranked.front();
    const std::string settings = settings_of(scene, best);
    fmt::print("advice     {}\n", settings);
    Scene result = advised(scene, best);
    result.given["the advice"] = settings;  // a checkpoint is for this, too
    return result;
}

void advise(const Scene& scene, double tolerance, bool quiet, const Pause& pause) {
    const Stopwatch watch;
    const Advice advice = announced_advice(scene, tolerance, quiet, pause);
    const Candidate& best = advice.ranked.front();
    if (!quiet) {
        fmt::print("scene      {}\n", scene.title);
        fmt::print("tolerance  {:g} of max |u|, {}\n\n", tolerance, what_counts(scene));
        print_ranked(scene, advice.ranked);
        print_left_out(scene, advice);
    }
    Simulation simulation(advised(scene, best));
    print_warnings(simulation.warnings());
    const double run = seconds_of_run(simulation);
    const double took = watch.seconds();
    constexpr double patience = 2;  // [s]
    constexpr double many_runs = 10;
    if (!quiet && (took > patience || took > many_runs * run)) {
        fmt::print(
            "took       {}, as {:.{}f} runs of what is advised: boundaries are predicted in time "
            "steps from the longest down{}, and those that meet the tolerance timed\n",
            duration(took), took / run, took < many_runs * run ? 1 : 0,
            has_open_lattice(scene) ? ", on lattices of each horizon and many G" : "");
    }
    fmt::print("advice     {}, cfl = {:.3g}\nsettings   {}\n", with_lattice_named(scene, best),
               best.cfl, settings_of(scene, best));
}

}  // namespace nmbcrun
