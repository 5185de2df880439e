// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane_compare/plane_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "generator/names/printable.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/csv.hpp"
#include "tools/nmbcrun/output/gnuplot.hpp"
#include "tools/nmbcrun/plane_compare/closed_measurement.hpp"
#include "tools/nmbcrun/plane_compare/side_measurement.hpp"
#include "tools/nmbcrun/terminal/interrupt.hpp"

namespace nmbcrun {

void chart_plane(const PlaneScene& scene, const PlaneChartOptions& options) {
    const bool is_physical = std::ranges::none_of(
        scene.sides, [](const PlaneSideChoice& side) { return is_artificial(side.kind); });
    if (is_physical && options.long_run) {
        throw SceneError(
            "--long-run is for sides that may feed energy in: between physical sides, which never "
            "do, there is none");
    }
    require_drawable("plane_chart.gp", options.folder);
    constexpr std::size_t by_default = 20'000;
    const std::size_t long_run = options.long_run.value_or(by_default);
    note_interrupts();
    CsvFile csv(options.folder / (scene.name + "_chart.csv"), side_points_header);
    std::vector<SidePoint> points =
        is_physical ? measure_closed_sides(scene, options.quiet)
                    : measure_sides(scene, side_candidates(scene), long_run, options.quiet);
    mark_front(points);
    write(points, csv);
    if (!options.quiet) {
        fmt::print(
            "step, run: over those between fixed sides, less 1; a run takes the longest stable "
            "steps\n{}; *: none is both cheaper and better\n",
            is_physical
                ? "error: against the same body on a finer lattice"
                : fmt::format("long run: of {} steps from a pulse of one node in a small box",
                              long_run));
        print(points);
    }
    fmt::print("chart        {}\n", nmbcgen::printable(csv.path().string()));
    const std::string picture = (options.folder / (scene.name + "_chart")).string();
    draw("plane_chart.gp", {csv.path().string(), picture, scene.title},
         {picture + ".svg", picture + ".png"});
}

}  // namespace nmbcrun
