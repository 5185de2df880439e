// SPDX-License-Identifier: MIT
/// The fields that a plane run keeps: its snapshots, and the end.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/nmbcrun/plane/plane_fields.hpp"

namespace nmbcrun {

/// FOLDER/NAME_snapshots/T.vti or .h5, T the step, and what opens them (write_series);
/// NAME_field.vti or .h5, the end. Snapshots wait for their run's end in a folder of its own,
/// NAME_snapshots.new-PROCESS. What else is in NAME_snapshots stays there. Every member throws
/// FileError.
class PlaneSnapshots {
  public:
    /// What a run of the scene replaces or removes: files, and the folder of snapshots.
    static std::vector<std::filesystem::path> replaced(const PlaneScene& scene,
                                                       const std::filesystem::path& folder);

    /// own_ending: of the run, as RunFiles has it. Throws FileError where something else than a
    /// file is in the way of one.
    PlaneSnapshots(const PlaneScene& scene, std::filesystem::path folder,
                   const std::string& own_ending);
    /// Removes snapshots that are not published, unless they are kept.
    ~PlaneSnapshots();
    PlaneSnapshots(const PlaneSnapshots&) = delete;
    PlaneSnapshots& operator=(const PlaneSnapshots&) = delete;
    PlaneSnapshots(PlaneSnapshots&&) = delete;
    PlaneSnapshots& operator=(PlaneSnapshots&&) = delete;

    /// With those that this run has left up to this step, which stay whatever becomes of it, or
    /// were published when it was stopped; later ones go; at step 0 anew. bytes: that a snapshot
    /// has at least. Throws FileError where one is missing or shorter.
    void begin(std::size_t step, double time_step, double bytes);

    void take(const PlaneSimulation& simulation);
    void keep(bool kept) { is_kept_ = kept; }
    /// Removes what other runs of this name have left in their folders, as far as it can: a run
    /// does not fail of it.
    void remove_leftovers() const;
    /// The field, if the scene asks for it, to be published: made before anything of an earlier run
    /// goes, it costs nothing where the disk does not take it.
    std::vector<nmbcgen::NewFile> new_field(const PlaneSimulation& simulation) const;
    /// In the place of what an earlier run of this name has left. field: of a run at its end.
    void publish(const PlaneSimulation& simulation, std::vector<nmbcgen::NewFile> field);

    /// A line each.
    std::string listed() const;

  private:
    /// "FILE is missing", or too short, of the snapshots in this folder; empty: nothing is.
    std::string what_lacks(const std::filesystem::path& folder, double bytes) const;
    std::filesystem::path growing() const { return folder_ / growing_; }
    std::filesystem::path file_of(std::size_t step) const;
    std::filesystem::path path(std::string_view ending) const;
    std::filesystem::path field() const;

    std::filesystem::path folder_;
    std::string name_;
    FieldFormat format_;
    std::size_t every_;
    bool has_field_;
    std::string series_;
    std::string growing_;  // the name of their folder
    bool is_kept_ = true;  // what a run goes on from stays whatever is wrong before it begins
    std::vector<Snapshot> snapshots_{};
};

}  // namespace nmbcrun
