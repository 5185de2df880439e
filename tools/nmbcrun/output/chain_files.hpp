// SPDX-License-Identifier: MIT
/// The files of a chain's run.
#pragma once

#include <filesystem>
#include <nmbc/chain.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tools/nmbcrun/output/run_files.hpp"
#include "tools/nmbcrun/output/sample.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Beside the energies NAME_probes.csv and NAME.h5 (the snapshots) where the scene has some;
/// NAME_field.csv where it asks for it.
class ChainFiles : public RunFiles {
  public:
    /// about: what the energies are to say of the run, whole lines; marks: of a run that goes on;
    /// none: it starts. Throws FileError and SceneError as RunFiles do.
    ChainFiles(const Scene& scene, const std::filesystem::path& folder, std::string_view about,
               std::vector<Journal::Mark> marks);

    /// A row of energies and of the probes.
    void record(const Sample& sample, const nmbc::Chain& chain);
    void take_snapshot(const nmbc::Chain& chain);

    /// Publishes what is there, of a run that has reached its end the field, too.
    void publish(const nmbc::Chain& chain, bool at_end);

    std::string listed() const override;

  private:
    std::vector<std::size_t> probes_;
    bool has_field_;
    Journal* probed_ = nullptr;     // none without probes
    Journal* snapshots_ = nullptr;  // nor without snapshots
};

}  // namespace nmbcrun
