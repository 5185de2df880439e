// SPDX-License-Identifier: MIT
/// nmbcrun chart: what every boundary costs a scene, and how good it is.
#pragma once

#include <cstddef>
#include <filesystem>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Runs the scene with every boundary of the ladder in several time steps, times them beside the
/// bare interior and follows each through a long run. Writes FOLDER/NAME_chart.csv, a row for each
/// boundary and step, and prints a table. endurance: steps of the long runs.
/// Throws as Simulation does, and FileError.
void chart(const Scene& scene, const std::filesystem::path& folder, std::size_t endurance,
           bool quiet);

}  // namespace nmbcrun
