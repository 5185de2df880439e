// SPDX-License-Identifier: MIT
/// nmbcrun chart, of a plane scene: what its sides cost, and how good they are.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "tools/nmbcrun/plane/plane_scene.hpp"

namespace nmbcrun {

struct PlaneChartOptions {
    std::filesystem::path folder;         ///< for what the chart writes
    std::optional<std::size_t> long_run;  ///< steps; none: 20 000
    bool quiet = false;                   ///< only the last lines on stdout
};

/// Writes what measure_sides() finds of every kind of side there is to FOLDER/NAME_chart.csv, draws
/// it and prints a table; measure_closed_sides() where no side is artificial. Throws as these do,
/// SceneError for a long run of the latter, and FileError.
void chart_plane(const PlaneScene& scene, const PlaneChartOptions& options);

}  // namespace nmbcrun
