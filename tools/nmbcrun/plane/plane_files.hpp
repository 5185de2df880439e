// SPDX-License-Identifier: MIT
/// The files of a plane run.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/nmbcrun/output/run_files.hpp"
#include "tools/nmbcrun/plane/crack_front.hpp"
#include "tools/nmbcrun/plane/plane_simulation.hpp"
#include "tools/nmbcrun/plane/plane_snapshots.hpp"

namespace nmbcrun {

/// Beside the energies NAME_probes.csv; NAME_cracks.csv; those of PlaneSnapshots.
class PlaneFiles : public RunFiles {
  public:
    /// about: what the energies are to say of the run, whole lines; marks: of a run that goes on;
    /// none: it starts. Throws FileError and SceneError as RunFiles do.
    PlaneFiles(const PlaneSimulation& simulation, const std::filesystem::path& folder,
               std::string_view about, std::vector<Journal::Mark> marks);

    /// A row of energies and of the probes.
    void record(const PlaneSimulation& simulation, const nmbc::PlaneEnergies& energies,
                const PlaneBalance& balance);
    void take_snapshot(const PlaneSimulation& simulation) { snapshots_.take(simulation); }
    void keep(bool kept) override;
    void remove_leftovers() const override;
    /// What is there, in the place of what an earlier run of this name has left; of a run that has
    /// reached its end the field, too.
    void publish(const PlaneSimulation& simulation, bool at_end);

    // Of a scene with fracture:
    const CrackFront& front() const { return *front_; }
    std::vector<CrackGrowth> growth(const PlaneSimulation& simulation) const;
    struct CrackRow {
        double time = 0;
        double broken = 0;
        std::vector<double> reach{};     ///< of each end of a crack
        std::vector<double> branches{};  ///< likewise
    };
    std::vector<CrackRow> crack_rows() const;

    std::string listed() const override;

  private:
    Journal* probed_ = nullptr;          // none without probes
    Journal* cracked_ = nullptr;         // none without fracture
    std::optional<CrackFront> front_{};  // likewise
    PlaneSnapshots snapshots_;
};

}  // namespace nmbcrun
