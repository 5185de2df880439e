// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane_compare/closed_measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/first_steps.hpp"
#include "tools/nmbcrun/output/work.hpp"
#include "tools/nmbcrun/plane/finer_run.hpp"
#include "tools/nmbcrun/plane/plane_sides.hpp"
#include "tools/nmbcrun/plane/same_body.hpp"
#include "tools/nmbcrun/plane_compare/side_trial.hpp"
#include "tools/nmbcrun/stepping/plane_stepping.hpp"

namespace nmbcrun {
namespace {

/// The sides with such a one wherever the body ends.
std::array<PlaneSideChoice, 4> closed_by(std::array<PlaneSideChoice, 4> sides, SideKind kind) {
    for (PlaneSideChoice& side : sides) {
        if (ends_body(side.kind)) {
            side = {.kind = kind};
        }
    }
    return sides;
}

std::vector<SidePoint> closures_of(const PlaneScene& scene) {
    if (std::ranges::none_of(scene.sides,
                             [](const PlaneSideChoice& side) { return ends_body(side.kind); })) {
        throw SceneError(
            "a chart compares artificial sides, or the closures of sides where the body ends, sbp, "
            "kernel and free: there is none (nmbcrun verify compares with a finer lattice)");
    }
    if (scene.is_bond_based()) {
        throw SceneError(
            "a chart compares artificial sides, or the closures of sides where the body ends, and "
            "bonds have one only, free (nmbcrun verify compares it with a finer lattice)");
    }
    std::vector<SidePoint> points{{.what = {"sbp", {.kind = SideKind::sbp}}}};
    if (!scene.influence.empty()) {
        points.push_back({.what = {"kernel", {.kind = SideKind::kernel}}});
    }
    points.push_back({.what = {"free", {.kind = SideKind::free}}});
    return points;
}

/// Without what moves it, for its time alone.
PlaneScene at_rest(PlaneScene scene) {
    scene.initial.reset();
    scene.force.reset();
    scene.drive.reset();
    scene.loads.clear();
    return scene;
}

/// One of the closures, beside the reference.
struct ClosureTrial {
    SameBody body;
    std::optional<PlaneSimulation> simulation{};
    std::optional<CommonNodes> nodes{};
    double timing = 0;  ///< [s]
};

class ClosureMeasurement {
  public:
    ClosureMeasurement(const PlaneScene& scene, bool quiet)
        : quiet_(quiet),
          points_(closures_of(scene)),
          sides_(sides_of(scene, quiet).all),
          finer_(finer_body(scene, sides_)),
          original_(scene, sides_) {
        trials_.resize(points_.size());
    }

    std::vector<SidePoint> run() {
        find_steps();
        run_beside_reference();
        measure_costs();
        work_.reset();
        for (const SidePoint& point : points_) {
            if (!point.refused.empty()) {
                fmt::print(stderr, "nmbcrun: left out: {}: {}\n", point.what.name, point.refused);
            }
        }
        std::erase_if(points_, [](const SidePoint& point) { return !point.refused.empty(); });
        return std::move(points_);
    }

  private:
    template <class Job>
    void on_points(const Job& job) {
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (points_[i].refused.empty()) {
                points_[i].refused = refusal_of([&] { job(points_[i], trials_[i]); });
            }
        }
    }

    void require_points() const;
    void find_steps();
    void foresee_timing();
    double total_timing() const;
    void run_beside_reference();
    void measure_costs();

    bool quiet_;
    std::vector<SidePoint> points_;
    nmbc::PlaneSides sides_;  // of the scene
    SameBody finer_;
    PlaneSimulation original_;
    std::vector<ClosureTrial> trials_{};  // of the points
    double step_ = 0;
    std::optional<Work> work_{};
};

/// Throws SceneError where none is left.
void ClosureMeasurement::require_points() const {
    std::vector<std::string> refusals;
    for (const SidePoint& point : points_) {
        if (point.refused.empty()) {
            return;
        }
        refusals.push_back(fmt::format("{}: {}", point.what.name, point.refused));
    }
    throw SceneError(
        fmt::format("no closure of this body can be compared. {}", fmt::join(refusals, "; ")));
}

/// The shortest that any of them takes, unless the scene has its own.
void ClosureMeasurement::find_steps() {
    step_ = original_.plan().time_step;
    const bool is_given = original_.scene().step || original_.scene().cfl;
    on_points([&](SidePoint& point, ClosureTrial& trial) {
        const auto sides = closed_by(original_.scene().sides, point.what.side.kind);
        trial.body = same_body(original_.scene(), sides_, sides, 1);
        const PlanePlan plan = PlaneSimulation(trial.body.scene, trial.body.sides).plan();
        point.longest_step = plan.time_step / plan.of_stable;
        step_ = is_given ? step_ : std::min(step_, plan.time_step);
    });
    require_points();
}

/// What it takes to tell what they cost.
void ClosureMeasurement::foresee_timing() {
    on_points([&](const SidePoint&, ClosureTrial& trial) {
        trial.timing = 2 * double(cost_pairs) * timed_burst(*trial.simulation).seconds;
    });
}

double ClosureMeasurement::total_timing() const {
    double total = 0;
    for (const ClosureTrial& trial : trials_) {
        total += trial.timing;
    }
    return total;
}

void ClosureMeasurement::run_beside_reference() {
    ReferenceRun reference = finer_run(std::move(finer_), step_);
    on_points([&](SidePoint& point, ClosureTrial& trial) {
        if (!(step_ < point.longest_step)) {
            throw SceneError(
                fmt::format("steps of {:.6g} are too long: beside it those below {:.6g} are stable",
                            step_, point.longest_step));
        }
        trial.body.scene.step = step_;
        trial.simulation.emplace(trial.body.scene, trial.body.sides);
        trial.nodes.emplace(*trial.simulation, reference.simulation);
    });
    require_points();
    const auto steps = steps_until(original_.scene().end, step_);
    double peak = reference.simulation.energies().total();
    double largest = 0;  // |u_ref| at nodes that any of them shares with it: one unit for all
    const auto advance = [&] {
        reference.advance();
        peak = std::max(peak, reference.simulation.energies().total());
        on_points([&](SidePoint& point, ClosureTrial& trial) {
            trial.simulation->advance(1);
            const auto now = trial.nodes->between(*trial.simulation, reference.simulation);
            largest = std::max(largest, now.other);
            if (!(now.largest <= point.error)) {
                point.error = std::isfinite(now.largest) ? now.largest
                                                         : std::numeric_limits<double>::infinity();
            }
        });
    };
    const auto [first, a_step] = take_first_steps(steps, advance);
    foresee_timing();
    work_.emplace(double(steps - first) * a_step + total_timing(), quiet_);
    for (std::size_t step = first; step < steps; ++step) {
        advance();
        work_->add(a_step);
    }
    if (!(largest > 0)) {
        throw nothing_to_compare_with();
    }
    on_points([&](SidePoint& point, ClosureTrial& trial) {
        point.error /= largest;
        point.energy_left = trial.simulation->energies().total() / peak;
    });
}

void ClosureMeasurement::measure_costs() {
    PlaneScene bare = at_rest(original_.scene());
    bare.nodes = original_.body().nodes;
    bare.sides = closed_by(bare.sides, SideKind::fixed);
    bare.step.reset();
    bare.cfl.reset();
    PlaneSimulation fixed(bare, quiet_);
    const double bare_step = fixed.plan().time_step / fixed.plan().of_stable;
    on_points([&](SidePoint& point, ClosureTrial& trial) {
        PlaneSimulation simulation(at_rest(trial.body.scene), trial.body.sides);
        point.step_cost =
            relative_cost(simulation, fixed, work_->of(std::exchange(trial.timing, 0)));
        point.run_cost = point.step_cost * bare_step / point.longest_step;
    });
    work_->add(total_timing());  // of what was refused
}

}  // namespace

std::vector<SidePoint> measure_closed_sides(const PlaneScene& scene, bool quiet) {
    const InOneThread steps;
    return ClosureMeasurement(scene, quiet).run();
}

}  // namespace nmbcrun
