// SPDX-License-Identifier: MIT
/// What a chart knows of each kind of side, and how it is told.
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "tools/nmbcrun/output/csv.hpp"
#include "tools/nmbcrun/plane_compare/side_candidates.hpp"

namespace nmbcrun {

struct SidePoint {
    SideCandidate what;
    std::string refused{};    ///< why the scene cannot have it, in words; empty: it can
    double longest_step = 0;  ///< that is stable [time]
    double error = 0;         ///< max |u - u_ref| over max |u_ref|
    double energy_left = 0;   ///< over the peak
    double step_cost = 0;     ///< of a step, over that between fixed sides
    double run_cost = 0;      ///< with shorter steps, too, where it needs such
    bool grows = false;       ///< in the long run, of those that may
    bool on_front = false;

    bool holds() const { return refused.empty() && !grows && std::isfinite(error); }
    std::string_view long_run() const {
        return !may_grow(what.side.kind) ? "by construction" : grows ? "grows" : "steady";
    }
};

/// Marks the points that no other one that holds beats in both run cost and error: of artificial
/// sides, where there are any.
void mark_front(std::vector<SidePoint>& points);

/// The columns of a chart's CSV.
extern const char* const side_points_header;

/// A row for each point.
void write(const std::vector<SidePoint>& points, CsvFile& csv);

/// A table, best first.
void print(const std::vector<SidePoint>& points);

}  // namespace nmbcrun
