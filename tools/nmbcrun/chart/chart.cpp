// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/chart/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <nmbc/chain.hpp>
#include <nmbc/ends.hpp>
#include <nmbc/lattice.hpp>
#include <nmbc/surface.hpp>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "generator/names/printable.hpp"
#include "generator/support/on_all_cores.hpp"
#include "tools/nmbcrun/certification/time_step.hpp"
#include "tools/nmbcrun/chart/boundaries.hpp"
#include "tools/nmbcrun/chart/chart_work.hpp"
#include "tools/nmbcrun/chart/cost.hpp"
#include "tools/nmbcrun/chart/long_run.hpp"
#include "tools/nmbcrun/chart/pace.hpp"
#include "tools/nmbcrun/chart/points.hpp"
#include "tools/nmbcrun/chart/trial.hpp"
#include "tools/nmbcrun/chart/tuning.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/csv.hpp"
#include "tools/nmbcrun/output/gnuplot.hpp"
#include "tools/nmbcrun/output/work.hpp"
#include "tools/nmbcrun/scene/step_plan.hpp"
#include "tools/nmbcrun/tables/tables.hpp"
#include "tools/nmbcrun/terminal/duration.hpp"

namespace nmbcrun {
namespace {

/// Of the lattice without damping.
constexpr std::array cfls{0.1, 0.2, 0.4, 0.8};
constexpr double shown_cfl = 0.4;
constexpr double fine_cfl = 0.0125;  // an eighth of the smallest: an error 1/64 of its

class Measurement {
  public:
    Measurement(const Scene& scene, std::vector<double> steps, std::size_t long_run)
        : scene_(scene), long_run_(long_run), steps_(std::move(steps)) {
        shown_ = *std::ranges::find_if(steps_.rbegin(), steps_.rend(),
                                       [](double cfl) { return cfl <= shown_cfl; });
        for (const double cfl : steps_) {
            for (const NamedBoundary& what : boundaries_of(scene)) {
                points_.push_back({.what = what, .cfl = cfl});
            }
        }
        takes_.emplace(scene_, pace_of(in_steps(shown_)), long_run_);
    }

    double shown() const { return shown_; }
    double seconds() const { return total_work(); }

    std::vector<Point> run(bool quiet) {
        Work work(total_work(), quiet);
        run_references(work);
        tune_layers(work);
        run_trials(work);
        leave_out_refused();
        measure_costs(work);
        mark_fronts(points_, steps_);
        return std::move(points_);
    }

  private:
    Scene in_steps(double cfl) const { return in_steps_of(scene_, cfl); }
    Scene ended(const Point& point) const { return ended_by(scene_, point); }
    /// Without artificial ends: of closures, between mirrors about the same surfaces.
    Scene reference(double cfl, bool is_on_node) const {
        const BoundaryKind kind = !is_closed(scene_) ? BoundaryKind::extended
                                  : is_on_node       ? BoundaryKind::node_mirror
                                                     : BoundaryKind::mirror;
        return with_ends(in_steps(cfl), {.kind = kind});
    }
    static bool is_on_node(const Point& point) {
        const BoundaryKind kind = point.what.boundary.kind;
        return is_surface(kind) && nmbc::ends_on_node(closure_of(kind));
    }
    std::vector<bool> surfaces() const {
        return is_closed(scene_) ? std::vector{false, true} : std::vector{false};
    }
    static bool is_tuned(const Boundary& boundary) {
        return has_profile(boundary.kind) ||
               (boundary.kind == BoundaryKind::extended && boundary.layer == 0);
    }

    /// A step takes the same time whatever its length, but that of an exact end, which remembers
    /// all of them.
    bool is_timed(const Point& point) const {
        return point.cfl == shown_ || point.what.boundary.kind == BoundaryKind::exact;
    }

    double total_work() const;
    void run_references(Work& work);
    void tune_layers(Work& work);
    void run_trials(Work& work);
    void leave_out_refused();
    void measure_costs(Work& work);

    Scene scene_;
    std::size_t long_run_;
    std::vector<double> steps_;
    double shown_ = 0;
    std::optional<ChartWork> takes_{};
    std::map<bool, Samples> fine_;  // by is_on_node()
    std::map<std::pair<double, bool>, Samples> same_steps_;
    std::vector<Point> points_;
};

double Measurement::total_work() const {
    double total = takes_->run(reference(fine_cfl, false));
    for (const double cfl : steps_) {
        total += takes_->run(reference(cfl, false));
    }
    total *= double(surfaces().size());
    for (const Point& point : points_) {
        total += takes_->trial(point) + takes_->long_run(point);
        if (point.cfl == shown_) {
            total += is_tuned(point.what.boundary) ? takes_->tuning(point) : 0;
        }
        if (is_timed(point)) {
            total += takes_->timing(point);
        }
    }
    return total;
}

void Measurement::run_references(Work& work) {
    std::vector<std::pair<double, bool>> runs;
    for (const bool on_node : surfaces()) {
        fine_[on_node];
        runs.emplace_back(fine_cfl, on_node);
        for (const double cfl : steps_) {
            same_steps_[{cfl, on_node}];
            runs.emplace_back(cfl, on_node);
        }
    }
    nmbcgen::on_all_cores(runs.size(), [&](std::size_t i) {
        const auto& [cfl, on_node] = runs[i];
        (cfl == fine_cfl ? fine_.at(on_node) : same_steps_.at(runs[i])) = samples_without_ends(
            reference(cfl, on_node), work.of(takes_->run(reference(cfl, false))));
    });
}

/// At the cfl that is shown; what is best there is taken at all.
void Measurement::tune_layers(Work& work) {
    std::vector<Point*> layers;
    for (Point& point : points_) {
        if (point.cfl == shown_ && is_tuned(point.what.boundary)) {
            layers.insert(layers.begin(), &point);  // the widest of each kind take longest
        }
    }
    nmbcgen::on_all_cores(layers.size(), [&](std::size_t i) {
        Point& point = *layers[i];
        Boundary& boundary = point.what.boundary;
        Portion portion(work, takes_->tuning(point));
        const Advance advance = portion.of(takes_->tuning(point));
        point.refused = refusal_of([&] {
            boundary =
                boundary.kind == BoundaryKind::extended
                    ? narrowest_silent(in_steps(shown_), same_steps_.at({shown_, false}), advance)
                    : tuned(in_steps(shown_), boundary, same_steps_.at({shown_, false}), advance);
        });
        portion.finish();
    });
    for (const Point* layer : layers) {
        for (Point& point : points_) {
            if (point.what.name == layer->what.name) {
                point.what.boundary = layer->what.boundary;
                point.refused = layer->refused;
            }
        }
    }
}

void Measurement::run_trials(Work& work) {
    nmbcgen::on_all_cores(points_.size(), [&](std::size_t i) {
        Point& point = points_[i];
        Portion portion(work, takes_->trial(point) + takes_->long_run(point));
        if (point.refused.empty()) {
            point.refused = refusal_of([&] {
                point.trial =
                    run_trial(ended(point), same_steps_.at({point.cfl, is_on_node(point)}),
                              fine_.at(is_on_node(point)), portion.of(takes_->trial(point)));
                if (!adds_no_energy(point.what.boundary.kind)) {
                    point.long_run = long_time_stability(ended(point), long_run_,
                                                         portion.of(takes_->long_run(point)));
                }
            });
        }
        portion.finish();
        if (!point.refused.empty() && is_timed(point)) {  // it never will be
            work.add(takes_->timing(point));
        }
    });
}

void Measurement::leave_out_refused() {
    std::set<std::string> without_cost;
    for (const Point& point : points_) {
        if (!point.refused.empty() && point.cfl == shown_) {
            without_cost.insert(point.what.name);
        }
    }
    // Unless it is timed in each, one that is refused in the steps of the others' timing.
    const auto is_left_out = [&](const Point& point) {
        return !point.refused.empty() ||
               (!is_timed(point) && without_cost.contains(point.what.name));
    };
    std::set<std::string> shown;
    for (const Point& point : points_) {
        if (!is_left_out(point)) {
            shown.insert(point.what.name);
        }
    }
    std::set<std::string> told;
    for (const Point& point : points_) {
        const bool is_shown = shown.contains(point.what.name);
        const std::string where = is_shown ? fmt::format(" at cfl = {:g}", point.cfl) : "";
        if (!point.refused.empty() && told.insert(point.what.name + where).second) {
            fmt::print(stderr, "nmbcrun: left out{}: {}: {}\n", where, point.what.name,
                       point.refused);
        }
    }
    std::erase_if(points_, is_left_out);
}

void Measurement::measure_costs(Work& work) {
    std::vector<Point*> timed;
    std::vector<Scene> scenes;
    double total = 0;
    for (Point& point : points_) {
        if (is_timed(point)) {
            timed.push_back(&point);
            scenes.push_back(ended(point));
            total += takes_->timing(point);
        }
    }
    const std::vector<RelativeCost> costs = relative_costs(
        scenes, [&] { work.add(total / double(cost_rounds)); }, [&] { work.add(0); });
    for (std::size_t i = 0; i < timed.size(); ++i) {
        timed[i]->cost = costs[i];
    }
    for (Point& point : points_) {
        if (!is_timed(point)) {
            const auto name = [](const Point* one) { return one->what.name; };
            point.cost = (*std::ranges::find(timed, point.what.name, name))->cost;
        }
    }
}

/// Some of those that could add energy take a second or so each.
std::size_t default_long_run(const Scene& scene) {
    constexpr double most_node_steps = 5e8;
    return std::size_t(std::clamp(most_node_steps / double(scene.nodes), 4000.0, 1e6));
}

}  // namespace

void chart(const Scene& scene, const ChartOptions& options) {
    if (is_physical(scene.left.kind) && is_physical(scene.right.kind) && !is_closed(scene)) {
        throw SceneError(
            "both ends are fixed or free: a chart compares artificial ends, or ways to close a "
            "surface, such as \"mirror\"");
    }
    require_drawable("chart.gp", options.folder);
    const nmbc::Lattice lattice = lattice_of(scene);
    double limit = nmbc::interior_cfl(lattice);
    if (!is_closed(scene)) {  // closures that are compared are left out where steps are too long
        limit = std::min(limit, surface_limits(scene, lattice).least());
    }
    std::vector<double> steps;
    std::ranges::copy_if(cfls, std::back_inserter(steps),
                         [limit](double cfl) { return cfl <= limit; });
    if (steps.empty()) {
        throw SceneError(fmt::format(
            "a chart begins at cfl {}, and steps here are stable to {:.4g}", cfls.front(), limit));
    }
    CsvFile csv(options.folder / (scene.name + "_chart.csv"), points_header);
    const std::size_t long_run = options.long_run.value_or(default_long_run(scene));
    Measurement measurement(scene, std::move(steps), long_run);
    if (!options.quiet) {
        fmt::print("takes        about {} on {} cores that do nothing else\n\n",
                   duration(measurement.seconds()), nmbcgen::cores());
        std::fflush(stdout);
    }
    const std::vector<Point> points = measurement.run(options.quiet);
    write(points, scene.nodes, csv);
    if (!options.quiet) {
        print(points, measurement.shown(), long_run);
    }
    fmt::print("chart        {}\n", nmbcgen::printable(csv.path().string()));
    const std::string picture = (options.folder / (scene.name + "_chart")).string();
    draw("chart.gp", {csv.path().string(), picture}, {picture + ".svg", picture + ".png"});
}

}  // namespace nmbcrun
