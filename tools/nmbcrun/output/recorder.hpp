// SPDX-License-Identifier: MIT
/// The files of a run.
#pragma once

#include <filesystem>
#include <memory>
#include <nmbc/chain.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tools/nmbcrun/output/journal.hpp"
#include "tools/nmbcrun/output/sample.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// FOLDER/NAME.csv, the energies; NAME_probes.csv and NAME.h5 (the snapshots) where the scene has
/// some; NAME_field.csv where it asks for it. They grow under temporary names, and what is
/// published of them is whole. The energies so far are NAME.csv.part, a link, while the run lasts.
/// Every member throws FileError; the constructors do where something else than a file is in the
/// way of one, and SceneError where the scene reads one of them.
class Recorder {
  public:
    /// Of a run that starts; about: what its energies are to say of it, whole lines.
    Recorder(Scene scene, const nmbc::Chain& chain, std::filesystem::path folder,
             std::string_view about);
    /// Of one that goes on from these marks.
    Recorder(Scene scene, std::filesystem::path folder, const std::vector<Journal::Mark>& marks);

    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// A row of energies and of the probes.
    void record(const Sample& sample, const nmbc::Chain& chain);

    /// To be called at every step: takes a snapshot where one is due.
    void look(const nmbc::Chain& chain);

    /// Where to go on from, once all of it is on the disk.
    std::vector<Journal::Mark> marks() const;
    void sync();
    /// The energies so far can be read.
    void flush() { energies_->flush(); }
    /// From here on the growing files stay when the recorder ends, or do not.
    void keep(bool kept);

    /// Publishes what is there, of a run that has reached its end the field, too, all or nothing
    /// as far as the file system can do that; and removes what an earlier run has published of
    /// the others.
    void publish(const nmbc::Chain& chain, bool at_end);

    /// Removes what killed runs have left, and what no checkpoint but this run's needs.
    void remove_leftovers() const;

    /// About so many of the rows, and the last.
    std::vector<Sample> samples(std::size_t rows) const;

    /// The files of a whole run, a line each.
    std::string files() const;
    const std::filesystem::path& energies() const { return energies_->path(); }

  private:
    std::filesystem::path path(const char* ending) const;
    std::vector<Journal*> journals() const;
    void require_free_names() const;
    void link_growing() const;
    void remove_others(const std::vector<nmbcgen::NewFile>& files) const;

    Scene scene_;
    std::filesystem::path folder_;
    std::unique_ptr<Journal> energies_;
    std::unique_ptr<Journal> probed_;     // none without probes
    std::unique_ptr<Journal> snapshots_;  // nor without snapshots
};

}  // namespace nmbcrun
