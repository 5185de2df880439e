// SPDX-License-Identifier: MIT
/// A run in a file: all that it goes on from, bit for bit.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/nmbcrun/output/journal.hpp"
#include "tools/nmbcrun/scene/any_scene.hpp"
#include "tools/nmbcrun/scene/step_plan.hpp"

namespace nmbcrun {

/// Of a chain's run or a plane's.
struct Checkpoint {
    std::map<std::string, std::string> scene{};  ///< what must be the same when the run goes on
    std::uint64_t steps = 0;
    std::vector<std::vector<double>> state{};  ///< fields and sums, in an order of the run's own
    std::vector<Journal::Mark> journals{};
};

/// Puts it in the place of an older one, which is there until the new one is on the disk. Throws
/// FileError.
void save_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// Throws FileError where there is none, or none that is whole.
Checkpoint load_checkpoint(const std::filesystem::path& path);

/// What a run that goes on must have in common, with its steps and version: the keys of the scene
/// and the files that it names, as they are now; what changes no result is left out.
/// depends_on_end: whether a later end changes earlier steps. Throws FileError for a file that
/// cannot be read.
std::map<std::string, std::string> identity_of(const AnyScene& scene, bool depends_on_end,
                                               const StepPlan& plan,
                                               const std::vector<std::filesystem::path>& inputs);

/// Throws SceneError where the checkpoint's scene is not the given one, or is beyond the last step
/// of this run. path: of the checkpoint.
void require_resumable(const std::map<std::string, std::string>& given, std::size_t last_step,
                       const Checkpoint& checkpoint, const std::filesystem::path& path);

}  // namespace nmbcrun
