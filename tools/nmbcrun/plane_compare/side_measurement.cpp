// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane_compare/side_measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generator/support/on_all_cores.hpp"
#include "tools/nmbcrun/chart/tuning.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/processor_clock.hpp"
#include "tools/nmbcrun/output/work.hpp"
#include "tools/nmbcrun/plane/plane_plan.hpp"
#include "tools/nmbcrun/plane/plane_sides.hpp"
#include "tools/nmbcrun/plane/plane_simulation.hpp"
#include "tools/nmbcrun/plane_compare/side_trial.hpp"
#include "tools/nmbcrun/stepping/plane_stepping.hpp"
#include "tools/nmbcrun/terminal/interrupt.hpp"

namespace nmbcrun {
namespace {

constexpr std::size_t tuning_runs = 21;
constexpr std::array profiles{1.0, 2.0, 3.0};

class SideMeasurement {
  public:
    SideMeasurement(PlaneScene scene, const std::vector<SideCandidate>& candidates,
                    std::size_t long_run, bool quiet)
        : scene_(std::move(scene)), long_run_(long_run), quiet_(quiet) {
        for (const SideCandidate& what : candidates) {
            points_.push_back({.what = what});
        }
        sides_.resize(points_.size());
        const PlaneScene fixed = with_sides(scene_, {.kind = SideKind::fixed});
        bare_step_ = longest_step(fixed, sides_of(fixed, quiet_).all);
    }

    std::vector<SidePoint> run() {
        find_steps();
        std::optional<PlaneSimulation> endless(std::in_place,
                                               in_steps({.kind = SideKind::extended}), quiet_);
        foresee(*endless);
        Work work(total_work(), quiet_);
        run_reference(*endless, work);
        endless.reset();  // the largest of all
        on_portions(
            work, [](const Foreseen& parts) { return parts.tuning; },
            [&](std::size_t i, Portion& portion) { tune(i, portion); });
        on_portions(
            work, [](const Foreseen& parts) { return parts.trial + parts.long_run; },
            [&](std::size_t i, Portion& portion) { run(i, portion); });
        for (const SidePoint& point : points_) {
            if (!point.refused.empty()) {
                fmt::print(stderr, "nmbcrun: left out: {}: {}\n", point.what.name, point.refused);
            }
        }
        measure_costs(work);
        std::erase_if(points_, [](const SidePoint& point) { return !point.refused.empty(); });
        return std::move(points_);
    }

  private:
    static double longest_step(const PlaneScene& scene, const nmbc::PlaneSides& sides) {
        const PlanePlan plan = PlaneSimulation(scene, sides).plan();
        return plan.time_step / plan.of_stable;
    }
    PlaneScene in_steps(const PlaneSideChoice& side) const {
        PlaneScene scene = with_sides(scene_, side);
        scene.step = step_;
        scene.cfl.reset();
        return scene;
    }
    PlaneSimulation simulation_of(std::size_t i) const {
        return {in_steps(points_[i].what.side), *sides_[i]};
    }
    void unless_refused(std::size_t i, const std::function<void()>& job) {
        if (points_[i].refused.empty()) {
            points_[i].refused = refusal_of(job);
        }
    }
    void on_points(const std::function<void(std::size_t)>& job) {
        nmbcgen::on_all_cores(points_.size(),
                              [&](std::size_t i) { unless_refused(i, [&] { job(i); }); });
    }

    /// What the work on a point takes [s], while all cores share it; its timing has one.
    struct Foreseen {
        double tuning = 0;
        double trial = 0;
        double long_run = 0;
        double timing = 0;
    };

    /// Likewise, each with its portion of the work, which counts as done then, of what is refused,
    /// too.
    void on_portions(Work& work, const std::function<double(const Foreseen&)>& size,
                     const std::function<void(std::size_t, Portion&)>& job) {
        nmbcgen::on_all_cores(points_.size(), [&](std::size_t i) {
            Portion portion(work, size(foreseen_[i]));
            unless_refused(i, [&] { job(i, portion); });
            portion.finish();
        });
    }

    void find_steps();
    Foreseen foreseen(std::size_t i, double bare_burst) const;
    void foresee(PlaneSimulation& endless);
    double total_work() const;
    void run_reference(PlaneSimulation& endless, Work& work);
    void tune(std::size_t i, Portion& portion);
    void run(std::size_t i, Portion& portion);
    void measure_costs(Work& work);

    PlaneScene scene_;
    std::size_t long_run_;
    bool quiet_;
    std::vector<SidePoint> points_{};
    std::vector<std::optional<nmbc::PlaneSides>> sides_{};  // of the points
    std::vector<Foreseen> foreseen_{};                      // likewise
    double of_reference_ = 0;                               // [s]
    double bare_step_ = 0;                                  // longest between fixed sides
    double step_ = 0;
    double steps_ = 0;
    PlaneSamples reference_{};
};

/// All take the longest step that is stable between any of them, unless the scene has its own.
void SideMeasurement::find_steps() {
    on_points([&](std::size_t i) {
        const PlaneScene scene = with_sides(scene_, points_[i].what.side);
        sides_[i] = sides_of(scene, quiet_).all;
        points_[i].longest_step = longest_step(scene, *sides_[i]);
    });
    step_ = bare_step_;
    const PlaneScene fixed = with_sides(scene_, {.kind = SideKind::fixed});
    if (fixed.step || fixed.cfl) {
        step_ = PlaneSimulation(fixed, quiet_).plan().time_step;
    } else {
        for (const SidePoint& point : points_) {
            if (point.refused.empty()) {
                step_ = std::min(step_, of_stable_by_default * point.longest_step);
            }
        }
        step_ = std::min(step_, PlaneSimulation(fixed, quiet_).plan().time_step);
    }
    steps_ = scene_.end / step_;
}

/// By the time of a few steps.
SideMeasurement::Foreseen SideMeasurement::foreseen(std::size_t i, double bare_burst) const {
    const PlaneSideChoice& side = points_[i].what.side;
    const double start = seconds_of_this_process();
    PlaneSimulation simulation = simulation_of(i);
    const double making = seconds_of_this_process() - start;
    const Burst burst = timed_burst(simulation);
    const double trial = (steps_ * burst.a_step + making) / double(nmbcgen::cores());
    Foreseen parts{.tuning = has_layer(side.kind) ? double(tuning_runs) * trial : 0,
                   .trial = trial,
                   .timing = double(cost_pairs) * (burst.seconds + bare_burst)};
    if (may_grow(side.kind)) {
        PlaneSimulation box = small_box(scene_, side);
        parts.long_run = double(long_run_) * timed_burst(box).a_step / double(nmbcgen::cores());
    }
    return parts;
}

/// Of all there is to be done; what cannot even begin is refused.
void SideMeasurement::foresee(PlaneSimulation& endless) {
    of_reference_ = steps_ * timed_burst(endless).a_step;
    PlaneSimulation bare(in_steps({.kind = SideKind::fixed}), quiet_);
    const double bare_burst = timed_burst(bare).seconds;
    foreseen_.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        stop_if_interrupted();
        unless_refused(i, [&] { foreseen_[i] = foreseen(i, bare_burst); });
    }
}

double SideMeasurement::total_work() const {
    double total = of_reference_;
    for (const auto& [tuning, trial, long_run, timing] : foreseen_) {
        total += tuning + trial + long_run + timing;
    }
    return total;
}

void SideMeasurement::run_reference(PlaneSimulation& endless, Work& work) {
    reference_ = samples_of(endless, work.of(of_reference_));
    if (!(reference_.largest > 0)) {
        throw nothing_to_compare_with();
    }
}

void SideMeasurement::tune(std::size_t i, Portion& portion) {
    PlaneSideChoice& side = points_[i].what.side;
    if (!has_layer(side.kind)) {
        return;
    }
    const Advance advance = portion.of(foreseen_[i].tuning / double(tuning_runs));
    const auto error_with = [&](const Losses& losses) {
        side.profile = losses.profile;
        side.target = losses.target;
        PlaneSimulation simulation(in_steps(side), quiet_);
        return run_trial(simulation, reference_, advance).error;
    };
    const Losses best = least_erring_losses(profiles, tuning_runs, error_with);
    side.profile = best.profile;
    side.target = best.target;
    sides_[i] = sides_of(in_steps(side), quiet_).all;
}

void SideMeasurement::run(std::size_t i, Portion& portion) {
    SidePoint& point = points_[i];
    PlaneSimulation simulation = simulation_of(i);
    const SideTrial trial = run_trial(simulation, reference_, portion.of(foreseen_[i].trial));
    point.error = trial.error;
    point.energy_left = trial.energy_left;
    point.grows =
        may_grow(point.what.side.kind) &&
        grows(small_box(scene_, point.what.side), long_run_, portion.of(foreseen_[i].long_run));
}

/// One after the other: what runs beside it changes what is measured.
void SideMeasurement::measure_costs(Work& work) {
    PlaneSimulation bare(in_steps({.kind = SideKind::fixed}), quiet_);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        SidePoint& point = points_[i];
        Portion portion(work, foreseen_[i].timing);
        if (point.refused.empty()) {
            PlaneSimulation simulation = simulation_of(i);
            point.step_cost = relative_cost(simulation, bare, portion.of(foreseen_[i].timing));
            point.run_cost = point.step_cost * bare_step_ / point.longest_step;
        }
        portion.finish();
    }
}

}  // namespace

std::vector<SidePoint> measure_sides(const PlaneScene& scene,
                                     const std::vector<SideCandidate>& candidates,
                                     std::size_t long_run, bool quiet) {
    const InOneThread steps;
    return SideMeasurement(scene, candidates, long_run, quiet).run();
}

}  // namespace nmbcrun
