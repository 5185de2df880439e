// SPDX-License-Identifier: MIT
/// What a chart knows of each boundary in each time step, and how it is told.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "tools/nmbcrun/chart/boundaries.hpp"
#include "tools/nmbcrun/chart/cost.hpp"
#include "tools/nmbcrun/chart/long_run.hpp"
#include "tools/nmbcrun/chart/trial.hpp"
#include "tools/nmbcrun/output/csv.hpp"

namespace nmbcrun {

struct Point {
    NamedBoundary what;
    double cfl = 0;  ///< of the chart; the trial's own is a little less
    RelativeCost cost{};
    Trial trial{};
    LongTimeStability long_run{};
    std::string refused{};       ///< why it cannot end this scene, in words; empty: it can
    bool on_front = false;       ///< of total cost against total error
    bool on_step_front = false;  ///< of step cost against boundary error, at this cfl

    double total_cost() const { return cost.of_run(trial.steps); }
    /// Over a step of the bare interior, the ends' construction shared out among the steps.
    double step_cost() const { return total_cost() / double(trial.steps); }
    /// Not so fixed and free ends, which send back everything: a chart has them to compare with.
    bool absorbs() const {
        return what.boundary.kind != BoundaryKind::fixed &&
               what.boundary.kind != BoundaryKind::free;
    }
    bool holds() const {
        return long_run.outcome == LongRun::steady && std::isfinite(trial.total_error);
    }
};

/// Marks the points that absorb, or close a surface, and that no other one that holds beats in both
/// respects.
void mark_fronts(std::vector<Point>& points, const std::vector<double>& cfls);

/// A line below a table that has a perfectly matched layer.
extern const char* const note_on_pml;

/// The columns of a chart's CSV.
extern const char* const points_header;

/// A row for each point. nodes: of the interior.
void write(const std::vector<Point>& points, std::size_t nodes, CsvFile& csv);

/// The points of one cfl, best first, and those of every cfl that do not hold in a long run of so
/// many steps.
void print(const std::vector<Point>& points, double cfl, std::size_t long_run);

}  // namespace nmbcrun
