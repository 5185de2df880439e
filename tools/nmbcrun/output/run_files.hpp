// SPDX-License-Identifier: MIT
/// The files of a run that grow while it lasts, whatever is run.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/nmbcrun/output/journal.hpp"

namespace nmbcrun {

/// FOLDER/NAME.csv, the energies, and further journals. They grow under temporary names, and what
/// is published of them is whole. The energies so far are NAME.csv.part, a link, while the run
/// lasts. Every member throws FileError.
class RunFiles {
  public:
    /// A file FOLDER/NAME with this ending. It begins so: NAME_field.csv can be the energies of a
    /// scene of that name. Empty: any is this.
    struct Kind {
        std::string_view ending;
        std::string_view beginning;
    };

    virtual ~RunFiles();
    RunFiles(const RunFiles&) = delete;
    RunFiles& operator=(const RunFiles&) = delete;
    RunFiles(RunFiles&&) = delete;
    RunFiles& operator=(RunFiles&&) = delete;

    /// Where to go on from, once all of it is on the disk.
    std::vector<Journal::Mark> marks() const;
    void sync();
    /// The energies so far can be read.
    void flush() { journals_.front().journal->flush(); }
    /// From here on the growing files stay when the files end, or do not.
    virtual void keep(bool kept);

    /// Removes what killed runs have left, and what no checkpoint but this run's needs.
    virtual void remove_leftovers() const;

    /// About `some` of the `all` rows of energies, and the last.
    std::vector<std::vector<double>> rows(std::size_t all, std::size_t some) const;

    /// The files of a whole run, a line each.
    virtual std::string listed() const;
    const std::filesystem::path& energies() const { return journals_.front().journal->path(); }

  protected:
    struct Set {
        std::filesystem::path folder;
        std::string name;
        std::string_view energies_header;
        std::vector<Kind> others;                   ///< that not every run of the name has
        std::span<const char* const> pictures{};    ///< how the names of its pictures go on
        std::vector<std::filesystem::path> inputs;  ///< files that the scene is read from
        std::vector<std::filesystem::path>
            further{};  ///< files and folders that a run replaces, too
    };

    /// about: what the energies are to say of the run, whole lines. marks: of a run that goes on;
    /// none: it starts. Throws SceneError where the scene reads what the run would replace, and
    /// where something else than a file is in the way of one.
    RunFiles(Set set, std::string_view about, std::vector<Journal::Mark> marks);

    /// The next journal, of this name in listed(): as its mark has it, or with this beginning.
    Journal& open(std::string label, std::string_view ending, std::string_view beginning);
    /// To be called behind the last open(): each mark has its journal.
    void begin();

    /// Copies of the journals, to be published.
    std::vector<nmbcgen::NewFile> copies();
    /// All or nothing, as far as the file system can do that; and removes what an earlier run has
    /// published of the others.
    void publish(std::vector<nmbcgen::NewFile> files) const;

    /// What tells the growing files of this run from those of others of its name, behind the names
    /// that they are published under; the same where it goes on from a checkpoint.
    std::string own_ending() const;

    Journal& energies_journal() { return *journals_.front().journal; }
    std::filesystem::path path(std::string_view ending) const;

  private:
    struct Labelled {
        std::string label;
        std::unique_ptr<Journal> journal;
    };

    void require_free_names() const;
    void require_not_read(const std::filesystem::path& name) const;

    Set set_;
    std::vector<Journal::Mark> marks_;  // of journals that go on
    std::vector<Labelled> journals_;    // the energies first
};

}  // namespace nmbcrun
