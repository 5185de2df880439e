// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane_compare/side_points.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tools/nmbcrun/chart/points.hpp"

namespace nmbcrun {
namespace {

/// What was chosen for the scene, in words.
std::string choice(const PlaneSideChoice& side) {
    return has_layer(side.kind)
               ? fmt::format("  profile {}, target {:.3g}", side.profile, side.target)
               : "";
}

}  // namespace

void mark_front(std::vector<SidePoint>& points) {
    const auto absorbs = [](const SidePoint& point) { return is_artificial(point.what.side.kind); };
    const bool any_absorbs = std::ranges::any_of(points, absorbs);
    for (SidePoint& point : points) {
        point.on_front = (absorbs(point) || !any_absorbs) && point.holds() &&
                         std::ranges::none_of(points, [&](const SidePoint& other) {
                             return other.holds() && other.run_cost <= point.run_cost &&
                                    other.error <= point.error &&
                                    (other.run_cost < point.run_cost || other.error < point.error);
                         });
    }
}

const char* const side_points_header =
    "boundary,kind,layer,profile,target,error,energy_left,step_cost,run_cost,long_run,on_front";

void write(const std::vector<SidePoint>& points, CsvFile& csv) {
    for (const SidePoint& point : points) {
        const PlaneSideChoice& side = point.what.side;
        csv.append(fmt::format(
            "{},{},{},{},{:.4g},{:.4g},{:.4g},{:.4g},{},{:d}", point.what.name, name_of(side.kind),
            side.layer,
            has_layer(side.kind) ? fmt::format("{},{}", side.profile, side.target) : ",",
            point.error, point.energy_left, point.step_cost, point.run_cost, point.long_run(),
            point.on_front));
    }
    csv.publish();
}

void print(const std::vector<SidePoint>& points) {
    std::vector<const SidePoint*> shown;
    shown.reserve(points.size());
    for (const SidePoint& point : points) {
        shown.push_back(&point);
    }
    std::ranges::sort(shown, {}, [](const SidePoint* point) { return point->error; });
    fmt::print("  {:<12}  {:>9}  {:>9}  {:>9}  {:>11}  {:>15}  {}\n", "boundary", "step", "run",
               "error", "energy left", "long run", "tuned");
    for (const SidePoint* point : shown) {
        fmt::print("{} {:<12}  {:>7.0f} %  {:>7.0f} %  {:9.2e}  {:11.2e}  {:>15}{}\n",
                   point->on_front ? "*" : " ", point->what.name, 100 * (point->step_cost - 1),
                   100 * (point->run_cost - 1), point->error, point->energy_left, point->long_run(),
                   choice(point->what.side));
    }
    if (std::ranges::any_of(
            shown, [](const SidePoint* point) { return point->what.side.kind == SideKind::pml; })) {
        fmt::print("{}", note_on_pml);
    }
}

}  // namespace nmbcrun
