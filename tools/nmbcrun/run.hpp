// SPDX-License-Identifier: MIT
/// Runs a scene.
#pragma once

#include <filesystem>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Runs the scene, writes FOLDER/NAME.csv (and NAME_field.csv where asked for) and prints a table
/// of energies on stdout; with `quiet`, only the energy left and the files. Throws SceneError (no
/// such table, a time step above the interior's limit), Unstable (before the run where its ends are
/// not certified; after one without energy) and Interrupted (what was computed up to there is
/// written), nmbc::CoefficientError, std::invalid_argument (parameters the runtime refuses),
/// FileError.
void run(const Scene& scene, const std::filesystem::path& folder, bool quiet);

}  // namespace nmbcrun
