// SPDX-License-Identifier: MIT
/// Runs a scene.
#pragma once

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/run_options.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Runs the scene, writes what it asks for (ChainFiles) and prints a table of energies on stdout,
/// and what was left, where it went and the files. Throws SceneError (no such table, a time step
/// above the interior's limit, a checkpoint of another scene, files of its own that it would
/// replace), Unstable (before the run where its ends are not certified; after one without energy),
/// Interrupted (what was computed up to there is written, and a checkpoint),
/// nmbc::CoefficientError, std::invalid_argument (parameters the runtime refuses), FileError (it
/// says whether there is a checkpoint to go on from).
void run(const Scene& scene, const RunOptions& options);

}  // namespace nmbcrun
