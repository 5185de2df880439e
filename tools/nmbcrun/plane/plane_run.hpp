// SPDX-License-Identifier: MIT
/// Runs and verifies plane scenes.
#pragma once

#include <filesystem>

#include "tools/nmbcrun/output/run_options.hpp"
#include "tools/nmbcrun/plane/plane_scene.hpp"

namespace nmbcrun {

/// Runs the scene, writes what it asks for (PlaneFiles) and prints a table of energies, what was
/// left and where it went. Throws as PlaneSimulation does; SceneError for a checkpoint of another
/// scene, Unstable where the energy grows or is none, Interrupted (what was computed up to there is
/// written, and a checkpoint), FileError (it says whether there is a checkpoint to go on from).
void run_plane(const PlaneScene& scene, const RunOptions& options);

/// The pictures of what a run of the scene has left in the folder: its energies and, of its
/// snapshots, the displacements. Throws as draw().
void draw_plane(const PlaneScene& scene, const std::filesystem::path& folder);

/// Compares the scene with the same one whose artificial sides are so far off that nothing returns,
/// and prints max |u - u_ref| over max |u_ref|: whether it is within the tolerance. Where no side
/// is artificial, or `finer` ones are asked for, the reference is finer_run(). Throws as
/// PlaneSimulation, finer_body() and finer_run() do, and Unstable where nothing moves or u is not
/// finite.
bool verify_plane(const PlaneScene& scene, double tolerance, bool finer, bool quiet);

}  // namespace nmbcrun
