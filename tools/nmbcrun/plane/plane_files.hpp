// SPDX-License-Identifier: MIT
/// The files of a plane run.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/nmbcrun/output/journal.hpp"
#include "tools/nmbcrun/plane/crack_front.hpp"
#include "tools/nmbcrun/plane/plane_simulation.hpp"
#include "tools/nmbcrun/plane/plane_snapshots.hpp"

namespace nmbcrun {

/// FOLDER/NAME.csv, the energies; NAME_probes.csv; NAME_cracks.csv; those of PlaneSnapshots. Every
/// member throws FileError.
class PlaneFiles {
  public:
    /// Throws FileError where something else than a file is in the way of one.
    PlaneFiles(const PlaneSimulation& simulation, std::filesystem::path folder,
               std::string_view about);

    /// Of a run that goes on from these marks.
    PlaneFiles(const PlaneSimulation& simulation, std::filesystem::path folder,
               const std::vector<Journal::Mark>& marks);

    /// A row of energies and of the probes.
    void record(const PlaneSimulation& simulation, const nmbc::PlaneEnergies& energies,
                const PlaneBalance& balance);
    void take_snapshot(const PlaneSimulation& simulation) { snapshots_.take(simulation); }
    void flush() { energies_->flush(); }
    /// Where to go on from, once all of it is on the disk.
    std::vector<Journal::Mark> marks() const;
    void sync();
    /// From here on the growing files stay when this object ends, or do not.
    void keep(bool kept);
    /// What is there, in the place of what an earlier run of this name has left; of a run that has
    /// reached its end the field, too.
    void publish(const PlaneSimulation& simulation, bool at_end);

    /// Removes the growing files of killed runs that no process has open.
    void remove_leftovers() const;

    /// time, kinetic, strain, stabilisation, total, .. of about so many of the rows, and the last.
    std::vector<std::vector<double>> rows(std::size_t wanted) const;

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

    /// A line each.
    std::string listed() const;
    const std::filesystem::path& energies() const { return energies_->path(); }

  private:
    PlaneFiles(const PlaneSimulation& simulation, std::filesystem::path folder);
    std::vector<Journal*> journals() const;
    std::filesystem::path path(const char* ending) const { return folder_ / (name_ + ending); }

    std::filesystem::path folder_;
    std::string name_;
    std::unique_ptr<Journal> energies_{};
    std::unique_ptr<Journal> probed_{};   // none without probes
    std::unique_ptr<Journal> cracked_{};  // none without fracture
    std::optional<CrackFront> front_{};   // likewise
    PlaneSnapshots snapshots_;
};

}  // namespace nmbcrun
