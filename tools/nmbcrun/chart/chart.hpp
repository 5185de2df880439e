// SPDX-License-Identifier: MIT
/// nmbcrun chart: what every boundary costs a scene, and how good it is.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

struct ChartOptions {
    std::filesystem::path folder;  ///< for what the chart writes
    std::optional<std::size_t>
        long_run;        ///< steps of the long runs; none: as many as take a second
    bool quiet = false;  ///< only the last lines on stdout
};

/// Runs the scene with every boundary of boundaries_of() in several time steps, layers as tuned()
/// has them, times each beside the bare interior and follows those that could add energy through a
/// long run. Writes FOLDER/NAME_chart.csv, a row for each boundary and step, draws it and prints a
/// table. A boundary that cannot end this scene is left out, and named on stderr.
/// Throws as Simulation does, FileError and Interrupted.
void chart(const Scene& scene, const ChartOptions& options);

}  // namespace nmbcrun
