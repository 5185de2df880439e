// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane_compare/plane_advice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/plane_compare/plane_strip.hpp"
#include "tools/nmbcrun/plane_compare/side_candidates.hpp"
#include "tools/nmbcrun/plane_compare/side_measurement.hpp"
#include "tools/nmbcrun/terminal/duration.hpp"
#include "tools/nmbcrun/terminal/interrupt.hpp"
#include "tools/nmbcrun/terminal/stopwatch.hpp"

namespace nmbcrun {
namespace {

constexpr std::size_t steps_of_long_run = 20'000;

struct SideAdvice {
    std::optional<PlaneStrip> strip{};
    std::vector<SidePoint> ranked{};  ///< those that meet the tolerance, cheapest first
    std::vector<SidePoint> others{};
    bool has_artificial = false;

    static bool cannot_grow(const SidePoint& point) { return !may_grow(point.what.side.kind); }
    const SidePoint& best() const { return *std::ranges::find_if(ranked, &cannot_grow); }
};

SideAdvice advice_for(const PlaneScene& scene, double tolerance, bool quiet) {
    SideAdvice advice{.strip = strip_of(scene)};
    advice.has_artificial = std::ranges::any_of(
        scene.sides, [](const PlaneSideChoice& side) { return is_artificial(side.kind); });
    if (!advice.has_artificial) {
        if (!advice.strip) {
            throw SceneError(
                "all sides are physical, fixed, free, sbp, kernel, mirror or periodic, and the "
                "scene needs both dimensions: there is nothing to advise");
        }
        return advice;
    }
    std::vector<SideCandidate> candidates = side_candidates(scene);
    std::erase_if(candidates, [](const SideCandidate& one) {
        return one.side.kind == SideKind::nmbc || one.side.kind == SideKind::higdon ||
               !is_artificial(one.side.kind);
    });
    for (SidePoint& point : measure_sides(advice.strip ? advice.strip->scene : scene, candidates,
                                          steps_of_long_run, quiet)) {
        (point.holds() && point.error <= tolerance ? advice.ranked : advice.others)
            .push_back(std::move(point));
    }
    for (auto* const list : {&advice.ranked, &advice.others}) {
        std::ranges::sort(*list, {}, &SidePoint::run_cost);
    }
    return advice;
}

/// What to add to a command: one node along an axis, and the artificial sides, together where all
/// four are.
std::string settings_of(const PlaneScene& scene, const SideAdvice& advice) {
    std::vector<std::string> settings;
    if (advice.strip) {
        settings.push_back(advice.strip->settings);
    }
    if (!advice.has_artificial) {
        return settings.front();
    }
    const PlaneSideChoice& side = advice.best().what.side;
    const auto set = [&](const std::string& group) {
        settings.push_back(fmt::format("--set {}.kind={}", group, name_of(side.kind)));
        if (side.layer > 0) {
            settings.push_back(fmt::format("--set {}.layer={}", group, side.layer));
        }
        if (has_layer(side.kind)) {
            settings.push_back(fmt::format("--set {0}.profile={1} --set {0}.target={2}", group,
                                           side.profile, side.target));
        }
    };
    const auto is_open = [](const PlaneSideChoice& one) { return is_artificial(one.kind); };
    if (std::ranges::all_of(scene.sides, is_open)) {
        set("boundary");
    } else {
        for (std::size_t i = 0; i < scene.sides.size(); ++i) {
            if (is_open(scene.sides[i])) {
                set(fmt::format("boundary.{}", plane_side_names[i]));
            }
        }
    }
    return fmt::format("{}", fmt::join(settings, " "));
}

void print_strip(const PlaneStrip& strip, const PlaneScene& scene) {
    fmt::print(
        "dimension  all is alike along {0}: {1} of the {2} nodes there gives the same u to "
        "roundings,\n           and energies of {1}/{2}. NMBC, which lets out more, is for scenes "
        "of "
        "the chain of these\n           waves: docs/how-to/plane-waves.md\n",
        strip.axis == 0 ? 'x' : 'y', strip.scene.nodes[strip.axis], scene.nodes[strip.axis]);
}

std::string row(const SidePoint& point) {
    return fmt::format("  {:<12}  {:>7.0f} %  {:9.2e}", point.what.name, 100 * (point.run_cost - 1),
                       point.error);
}

void print_table(const SideAdvice& advice) {
    fmt::print("meets it           run      error\n");
    for (const SidePoint& point : advice.ranked) {
        fmt::print("{}{}\n", row(point),
                   SideAdvice::cannot_grow(point) ? "" : "  not stable by construction");
    }
    fmt::print("left out\n");
    for (const SidePoint& point : advice.others) {
        fmt::print("{}{}\n", row(point), point.grows ? "  grows" : "  above the tolerance");
    }
    fmt::print(
        "  NMBC, higdon  not certified in a plane\n"
        "run: over that between fixed sides, less 1, of layers with the losses that err least\n\n");
}

}  // namespace

PlaneScene as_advised(const PlaneScene& scene, double tolerance, bool quiet) {
    const SideAdvice advice = advice_for(scene, tolerance, quiet);
    const std::string settings = settings_of(scene, advice);
    fmt::print("advice     {}\n", settings);
    PlaneScene advised = advice.strip ? advice.strip->scene : scene;
    if (advice.has_artificial) {
        advised = with_sides(advised, advice.best().what.side);
        advised.allow_unstable = scene.allow_unstable;
    }
    advised.given["the advice"] = settings;  // a checkpoint is of this one
    return advised;
}

void advise_plane(const PlaneScene& scene, double tolerance, bool quiet) {
    note_interrupts();
    const Stopwatch watch;
    const SideAdvice advice = advice_for(scene, tolerance, quiet);
    if (advice.strip && !quiet) {
        print_strip(*advice.strip, scene);
    }
    if (advice.has_artificial) {
        if (!quiet) {
            print_table(advice);
            fmt::print(
                "took       {}: each side runs the scene beside a reference, layers with many "
                "losses, and what\n           may grow {} steps more\n",
                duration(watch.seconds()), steps_of_long_run);
        }
        fmt::print("advice     {}, error {:.1e}\n", heading_of(advice.best().what.side),
                   advice.best().error);
    }
    fmt::print("settings   {}\n", settings_of(scene, advice));
}

}  // namespace nmbcrun
