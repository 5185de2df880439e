// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/advise.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tools/nmbcrun/chart/cost.hpp"
#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {
namespace {

/// The scene as advised: boundaries and time step.
Scene advised(Scene scene, const Candidate& candidate) {
    scene.left = candidate.boundary;
    scene.right = candidate.boundary;
    scene.allow_unstable = false;
    if (!scene.step && !scene.cfl && candidate.boundary.matched_step == "0") {
        scene.cfl = candidate.cfl;
    }
    return scene;
}

/// The settings that make a scene the advised one, as --set takes them.
std::string settings_of(const Candidate& candidate) {
    const Boundary& boundary = candidate.boundary;
    std::string settings = fmt::format("--set boundary.kind={}", name_of(boundary.kind));
    if (boundary.kind == BoundaryKind::nmbc) {
        settings += fmt::format(" --set boundary.order={} --set boundary.stride={}", boundary.order,
                                boundary.stride);
        if (boundary.matched_step != "0") {
            return settings + fmt::format(" --set boundary.matched_step={}", boundary.matched_step);
        }
    }
    if (boundary.layer > 0) {
        settings += fmt::format(" --set boundary.layer={}", boundary.layer);
    }
    return settings + fmt::format(" --set time.cfl={:.4g}", candidate.cfl);
}

void measure_costs(const Scene& scene, std::vector<Candidate>& candidates) {
    std::vector<Scene> scenes;
    scenes.reserve(candidates.size());
    for (const Candidate& candidate : candidates) {
        scenes.push_back(advised(scene, candidate));
        scenes.back().step = candidate.time_step;
    }
    const auto costs = relative_costs(scenes, [] {});
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

}  // namespace

Advice advice_for(const Scene& scene, double tolerance) {
    Candidates candidates = find_candidates(scene, tolerance);
    if (candidates.meet.empty()) {
        std::string reasons;
        for (const LeftOut& one : candidates.left_out) {
            reasons += fmt::format("\n  {}: {}", one.name, one.reason);
        }
        throw SceneError(fmt::format("nothing meets the tolerance {:g}:{}", tolerance, reasons));
    }
    measure_costs(scene, candidates.meet);
    rank(candidates.meet);
    return {std::move(candidates.meet), std::move(candidates.left_out)};
}

Scene as_advised(const Scene& scene, double tolerance) {
    const Candidate best = advice_for(scene, tolerance).ranked.front();
    const std::string settings = settings_of(best);
    fmt::print("advice     {}\n", settings);
    Scene result = advised(scene, best);
    result.given["the advice"] = settings;  // a checkpoint is for this, too
    return result;
}

void advise(const Scene& scene, double tolerance, bool quiet) {
    const Advice advice = advice_for(scene, tolerance);
    const Candidate& best = advice.ranked.front();
    if (!quiet) {
        fmt::print("scene      {}\n", scene.title);
        fmt::print("tolerance  {:g} of max |u|, {}\n\n", tolerance,
                   scene.step || scene.cfl ? "in the scene's own time step"
                                           : "of the ends and of the time step together");
        fmt::print("{:<36}  {:>5}  {:>8}  {:>10}  {:>10}  {:>8}\n", "meets it by prediction", "cfl",
                   "steps", "ends", "time step", "cost");
        for (const Candidate& one : advice.ranked) {
            fmt::print("{:<36}  {:5.3f}  {:8}  {:10.1e}  {:10.1e}  {:8.2f}\n", one.name, one.cfl,
                       one.steps, one.boundary_error, one.time_error, one.cost / best.cost);
        }
        fmt::print("cost: time of the run over that of the first, measured now\n\nleft out\n");
        for (const LeftOut& one : advice.left_out) {
            fmt::print("  {:<36}  {}\n", one.name, one.reason);
        }
        if (!scene.field) {
            fmt::print("  {:<36}  {}\n", "stored fields", "nobody asked for them (output.field)");
        }
        fmt::print("\n");
    }
    fmt::print("advice     {}, cfl = {:.3g}\nsettings   {}\n", best.name, best.cfl,
               settings_of(best));
}

}  // namespace nmbcrun
