// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/chart/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nmbc/lattice.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "tools/nmbcrun/chart/cost.hpp"
#include "tools/nmbcrun/chart/endurance.hpp"
#include "tools/nmbcrun/chart/ladder.hpp"
#include "tools/nmbcrun/chart/trial.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/csv.hpp"
#include "tools/nmbcrun/output/interrupt.hpp"
#include "tools/nmbcrun/output/progress.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun {
namespace {

/// Of the lattice without damping.
constexpr std::array cfls{0.1, 0.2, 0.4, 0.8};
constexpr double printed_cfl = 0.4;
constexpr double fine_cfl = 0.0125;  // an eighth of the smallest: an error 1/64 of its

struct Point {
    const Rung* rung = nullptr;
    double cfl = 0;  ///< of `cfls`; the trial's own is a little less
    RelativeCost cost{};
    Trial trial{};
    Endurance endurance{};
    bool on_front = false;       ///< of total cost against total error
    bool on_step_front = false;  ///< of step cost against boundary error, at this cfl

    double total_cost() const { return cost.of_run(trial.steps); }
    /// Over a step of the bare interior, the ends' construction shared out among the steps.
    double step_cost() const { return total_cost() / double(trial.steps); }
    bool holds() const {
        return endurance.fate == Fate::steady && std::isfinite(trial.total_error);
    }
};

/// Counts units of work, and lets the user stop between two.
class Work {
  public:
    Work(std::size_t units, bool quiet) : progress_(units, quiet) {}

    void done() {
        progress_.update(++done_);
        if (interrupted()) {
            throw Interrupted("stopped; no chart was written");
        }
    }

  private:
    Progress progress_;
    std::size_t done_ = 0;
};

/// Marks those that no other one that holds beats in both respects.
template <class Cost, class Error>
void mark_front(std::vector<Point*> points, Cost cost, Error error, bool Point::*mark) {
    std::erase_if(points, [](const Point* point) { return !point->holds(); });
    for (Point* point : points) {
        point->*mark = std::ranges::none_of(points, [&](const Point* other) {
            return cost(*other) <= cost(*point) && error(*other) <= error(*point) &&
                   (cost(*other) < cost(*point) || error(*other) < error(*point));
        });
    }
}

void mark_fronts(std::vector<Point>& points) {
    std::vector<Point*> all;
    all.reserve(points.size());
    for (Point& point : points) {
        all.push_back(&point);
    }
    mark_front(
        all, [](const Point& point) { return point.total_cost(); },
        [](const Point& point) { return point.trial.total_error; }, &Point::on_front);
    for (const double cfl : cfls) {
        std::vector<Point*> same;
        std::ranges::copy_if(all, std::back_inserter(same),
                             [cfl](const Point* point) { return point->cfl == cfl; });
        mark_front(
            same, [](const Point& point) { return point.step_cost(); },
            [](const Point& point) { return point.trial.boundary_error; }, &Point::on_step_front);
    }
}

std::vector<Point> measure(const Scene& scene, const std::vector<Rung>& rungs,
                           const std::vector<double>& steps, std::size_t endurance, bool quiet) {
    std::vector<Point> points;
    std::vector<Scene> ended;
    for (const double cfl : steps) {
        for (const Rung& rung : rungs) {
            points.push_back({.rung = &rung, .cfl = cfl});
            ended.push_back(with_ends(in_steps_of(scene, cfl), rung.boundary));
        }
    }
    Work work(cost_rounds + 1 + steps.size() + 2 * points.size(), quiet);
    const std::vector<RelativeCost> costs = relative_costs(ended, [&work] { work.done(); });
    const Samples fine = samples_without_ends(in_steps_of(scene, fine_cfl));
    work.done();
    Samples same_steps;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i % rungs.size() == 0) {
            same_steps = samples_without_ends(in_steps_of(scene, points[i].cfl));
            work.done();
        }
        points[i].cost = costs[i];
        points[i].trial = run_trial(ended[i], same_steps, fine);
        work.done();
    }
    const std::vector<Endurance> fates = endure(ended, endurance, [&work] { work.done(); });
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i].endurance = fates[i];
    }
    mark_fronts(points);
    return points;
}

constexpr const char* header =
    "boundary,kind,cfl,steps,certified,fate,rate,step_cost,construction,total_cost,boundary_error,"
    "total_error,energy_left,on_step_front,on_front,layer_share";

/// nodes: of the interior.
void write(const std::vector<Point>& points, std::size_t nodes, CsvFile& csv) {
    for (const Point& point : points) {
        const Trial& trial = point.trial;
        csv.append(fmt::format(
            "{},{},{},{},{:d},{},{:.4g},{:.5g},{:.5g},{:.6g},{:.4g},{:.4g},{:.4g},"
            "{:d},{:d},{:.4g}",
            point.rung->name, name_of(point.rung->boundary.kind), point.cfl, trial.steps,
            trial.certified(), name_of(point.endurance.fate), point.endurance.rate, point.cost.step,
            point.cost.construction, point.total_cost(), trial.boundary_error, trial.total_error,
            trial.energy_left, point.on_step_front, point.on_front,
            2 * double(point.rung->boundary.layer) / double(nodes)));
    }
    csv.publish();
}

/// Those that do not hold in a long run, in all steps, and what their certificate says of it.
void print_failures(const std::vector<Point>& points) {
    fmt::print(
        "\ndrifts: as t^rate; unstable, grows: as exp(rate t)\n  {:<16}  {:>3}  {:>8}  {:>9}  {}\n",
        "boundary", "cfl", "fate", "rate", "certificate");
    for (const Point& point : points) {
        if (point.endurance.fate != Fate::steady) {
            fmt::print("  {:<16}  {:>3}  {:>8}  {:9.3g}  {}\n", point.rung->name, point.cfl,
                       name_of(point.endurance.fate), point.endurance.rate,
                       point.trial.certified() ? "stable" : point.trial.objection);
        }
    }
    fmt::print("\n");
}

/// The points of one step, best first; `*` on the front.
void print(const std::vector<Point>& points, std::size_t endurance) {
    std::vector<const Point*> shown;
    for (const Point& point : points) {
        if (point.cfl == printed_cfl) {
            shown.push_back(&point);
        }
    }
    std::ranges::sort(shown, {}, [](const Point* point) { return point->trial.boundary_error; });
    fmt::print(
        "at cfl {}; fate: of {} steps from random data; *: none is both cheaper and better\n",
        printed_cfl, endurance);
    fmt::print("  {:<16}  {:>10}  {:>14}  {:>12}  {:>9}  {}\n", "boundary", "cost", "error",
               "energy left", "certified", "fate");
    for (const Point* point : shown) {
        const Trial& trial = point->trial;
        fmt::print("{} {:<16}  {:>8.1f} %  {:14.3e}  {:12.3e}  {:>9}  {}\n",
                   point->on_step_front ? "*" : " ", point->rung->name,
                   100 * (point->step_cost() - 1), trial.boundary_error, trial.energy_left,
                   trial.certified() ? "yes" : "no", name_of(point->endurance.fate));
    }
}

/// Why an exact end cannot take part: it needs a scene at rest next to it, and memory of all steps.
std::string objection_to_exact(const Scene& exact) {
    if (exact.nodes <= 4 * lattice_of(exact).reach()) {
        return "the chain is too short to time it";
    }
    try {
        const Simulation simulation(exact);
        return "";
    } catch (const SceneError& error) {
        return error.what();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

}  // namespace

void chart(const Scene& scene, const std::filesystem::path& folder, std::size_t endurance,
           bool quiet) {
    const auto lattice = lattice_of(scene);
    std::vector<double> steps;
    std::ranges::copy_if(cfls, std::back_inserter(steps),
                         [&](double cfl) { return cfl <= nmbc::interior_cfl(lattice); });
    CsvFile csv(folder / (scene.name + "_chart.csv"), header);  // which may not be possible
    std::vector<Rung> rungs = ladder(scene);
    std::erase_if(rungs, [&](const Rung& rung) {
        if (rung.boundary.kind != BoundaryKind::exact) {
            return false;
        }
        const std::string objection =
            objection_to_exact(with_ends(in_steps_of(scene, steps.front()), rung.boundary));
        if (!objection.empty()) {
            fmt::print(stderr, "nmbcrun: left out: {}: {}\n", rung.name, objection);
        }
        return !objection.empty();
    });
    const std::vector<Point> points = measure(scene, rungs, steps, endurance, quiet);
    write(points, scene.nodes, csv);
    if (!quiet) {
        print(points, endurance);
        print_failures(points);
    }
    fmt::print("chart        {}\n", csv.path().string());
}

}  // namespace nmbcrun
