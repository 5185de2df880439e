// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/chart/chart_work.hpp"

#include <algorithm>
#include <utility>

#include "generator/support/on_all_cores.hpp"
#include "tools/nmbcrun/chart/boundaries.hpp"
#include "tools/nmbcrun/chart/cost.hpp"
#include "tools/nmbcrun/chart/node_steps.hpp"
#include "tools/nmbcrun/chart/trial.hpp"
#include "tools/nmbcrun/chart/tuning.hpp"
#include "tools/nmbcrun/scene/step_plan.hpp"

namespace nmbcrun {

Scene ended_by(const Scene& scene, const Point& point) {
    return with_ends(in_steps_of(scene, point.cfl), point.what.boundary);
}

ChartWork::ChartWork(Scene scene, const Pace& pace, std::size_t long_run)
    : scene_(std::move(scene)), pace_(pace), long_run_(long_run) {}

double ChartWork::seconds_of(const Scene& scene) const {
    return node_steps(scene) * pace_.step_by_step;
}

double ChartWork::run(const Scene& scene) const {
    return seconds_of(scene) / double(nmbcgen::cores());
}

double ChartWork::tuning(const Point& point) const {
    const bool is_layer = point.what.boundary.kind != BoundaryKind::extended;
    return trial(point) * (is_layer ? double(tuning_runs) : 10);
}

double ChartWork::trial(const Point& point) const {
    return run(ended_by(scene_, point));
}

double ChartWork::long_run(const Point& point) const {
    return adds_no_energy(point.what.boundary.kind) ? 0
                                                    : double(scene_.nodes) * double(long_run_) *
                                                          pace_.long_run / double(nmbcgen::cores());
}

double ChartWork::timing(const Point& point) const {
    const Scene ended = ended_by(scene_, point);
    const double bare = double(scene_.nodes) * double(steps_until(scene_.end, ended.step.value()));
    const double burst = std::max(timing_burst, 10.0 * double(scene_.nodes));
    const bool is_exact = point.what.boundary.kind == BoundaryKind::exact;
    const double own = seconds_of(ended) * (is_exact ? 1 : burst / bare);
    const double of_burst = burst * pace_.step_by_step;
    return std::min(double(cost_rounds), 1 + enough_timed / own) * (2 * of_burst + own) +
           std::min(enough_timed, double(making_rounds) * of_burst);
}

}  // namespace nmbcrun
