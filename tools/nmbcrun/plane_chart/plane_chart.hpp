// SPDX-License-Identifier: MIT
/// nmbcrun chart, of a plane scene: what its sides cost, and how good they are.
#pragma once

#include <cstddef>
#include <filesystem>

#include "tools/nmbcrun/plane/plane_scene.hpp"

namespace nmbcrun {

struct PlaneChartOptions {
    std::filesystem::path folder;   ///< for what the chart writes
    std::size_t long_run = 20'000;  ///< steps
    bool quiet = false;             ///< only the last lines on stdout
};

/// Runs the scene with each of side_candidates() in the place of its artificial sides, all in the
/// same steps, and compares with sides so far off that nothing returns; layers have the losses that
/// err least. Times each beside fixed sides, and follows those that may feed energy in through a
/// long run of a small box. Writes FOLDER/NAME_chart.csv, draws it and prints a table. What the
/// scene cannot have is left out, and named on stderr.
/// Throws as PlaneSimulation does, SceneError where no side is artificial, FileError, Interrupted.
void chart_plane(const PlaneScene& scene, const PlaneChartOptions& options);

}  // namespace nmbcrun
