// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/chart/points.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace nmbcrun {
namespace {

template <class Cost, class Error>
void mark_front(std::vector<Point*> points, Cost cost, Error error, bool Point::*mark) {
    std::erase_if(points, [](const Point* point) { return !point->holds(); });
    for (Point* point : points) {
        point->*mark = point->absorbs() && std::ranges::none_of(points, [&](const Point* other) {
                           return cost(*other) <= cost(*point) && error(*other) <= error(*point) &&
                                  (cost(*other) < cost(*point) || error(*other) < error(*point));
                       });
    }
}

/// What was chosen for the scene, in words.
std::string choice(const Boundary& boundary) {
    if (has_profile(boundary.kind)) {
        return fmt::format("  profile {}, target {:.3g}", boundary.profile, target_of(boundary));
    }
    return boundary.kind == BoundaryKind::extended ? fmt::format("  {} nodes", boundary.layer) : "";
}

void print_failures(const std::vector<Point>& points) {
    fmt::print(
        "\ndrifts: as t^rate; unstable, grows: as exp(rate t)\n  {:<16}  {:>3}  {:>8}  {:>9}  {}\n",
        "boundary", "cfl", "long run", "rate", "certificate");
    for (const Point& point : points) {
        if (point.long_run.outcome != LongRun::steady) {
            fmt::print("  {:<16}  {:>3}  {:>8}  {:9.3g}  {}\n", point.what.name, point.cfl,
                       name_of(point.long_run.outcome), point.long_run.rate,
                       point.trial.certified() ? "stable" : point.trial.objection);
        }
    }
    fmt::print("\n");
}

}  // namespace

void mark_fronts(std::vector<Point>& points, const std::vector<double>& cfls) {
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

const char* const note_on_pml =
    "the cost of a pml is that of nmbcrun's own, which is programmed plainly\n";

const char* const points_header =
    "boundary,kind,cfl,steps,certified,long_run,rate,step_cost,construction,total_cost,"
    "boundary_error,total_error,energy_left,on_step_front,on_front,layer_share,profile,target";

void write(const std::vector<Point>& points, std::size_t nodes, CsvFile& csv) {
    for (const Point& point : points) {
        const Trial& trial = point.trial;
        const Boundary& boundary = point.what.boundary;
        csv.append(fmt::format(
            "{},{},{},{},{:d},{},{:.4g},{:.5g},{:.5g},{:.6g},{:.4g},{:.4g},{:.4g},"
            "{:d},{:d},{:.4g},{}",
            point.what.name, name_of(boundary.kind), point.cfl, trial.steps, trial.certified(),
            name_of(point.long_run.outcome), point.long_run.rate, point.cost.step,
            point.cost.construction, point.total_cost(), trial.boundary_error, trial.total_error,
            trial.energy_left, point.on_step_front, point.on_front,
            2 * double(boundary.layer) / double(nodes),
            has_profile(boundary.kind) ? fmt::format("{},{}", boundary.profile, target_of(boundary))
                                       : ","));
    }
    csv.publish();
}

void print(const std::vector<Point>& points, double cfl, std::size_t long_run) {
    std::vector<const Point*> shown;
    for (const Point& point : points) {
        if (point.cfl == cfl) {
            shown.push_back(&point);
        }
    }
    std::ranges::sort(shown, {}, [](const Point* point) { return point->trial.boundary_error; });
    fmt::print(
        "at cfl {}; long run: of {} steps from random data; *: none is both cheaper and better\n",
        cfl, long_run);
    fmt::print("  {:<16}  {:>10}  {:>10}  {:>11}  {:>9}  {:>8}  {}\n", "boundary", "cost", "error",
               "energy left", "certified", "long run", "tuned");
    for (const Point* point : shown) {
        const Trial& trial = point->trial;
        fmt::print("{} {:<16}  {:>8.1f} %  {:10.2e}  {:11.2e}  {:>9}  {:>8}{}\n",
                   point->on_step_front ? "*" : " ", point->what.name,
                   100 * (point->step_cost() - 1), trial.boundary_error, trial.energy_left,
                   trial.certified() ? "yes" : "no", name_of(point->long_run.outcome),
                   choice(point->what.boundary));
    }
    if (std::ranges::any_of(shown, [](const Point* point) {
            return point->what.boundary.kind == BoundaryKind::pml;
        })) {
        fmt::print("{}", note_on_pml);
    }
    print_failures(points);
}

}  // namespace nmbcrun
