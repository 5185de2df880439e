// SPDX-License-Identifier: MIT
/// Whether a run can go on from a checkpoint, bit for bit.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "tools/nmbcrun/output/checkpoint.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"

namespace nmbcrun {

/// All that a run with these keys and plan goes on from must have in common, the name of a key
/// each; what changes no result is left out.
std::map<std::string, std::string> identity(const Simulation& simulation);

/// Throws SceneError where the checkpoint is of another run, or beyond the end of this one. path:
/// of the checkpoint.
void require_resumable(const Simulation& simulation, const Checkpoint& checkpoint,
                       const std::filesystem::path& path);

}  // namespace nmbcrun
