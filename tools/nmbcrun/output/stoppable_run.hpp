// SPDX-License-Identifier: MIT
/// A scene on its way from its start, or from a checkpoint, to its end, whatever is stepped.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/checkpoint.hpp"
#include "tools/nmbcrun/output/run_files.hpp"
#include "tools/nmbcrun/output/run_lock.hpp"
#include "tools/nmbcrun/output/run_options.hpp"
#include "tools/nmbcrun/output/step_warnings.hpp"
#include "tools/nmbcrun/scene/any_scene.hpp"
#include "tools/nmbcrun/scene/step_plan.hpp"

namespace nmbcrun {

/// What a run keeps of its energies for its last lines.
struct Highlights {
    double peak = 0;         ///< the largest total energy of every tenth step
    double driven_peak = 0;  ///< and of those under a source
    double drift = 0;        ///< the largest of the ledger, whatever its sign
};

/// What it takes of a machine: nodes that are stepped, those that are written, and numbers of
/// probes.
struct RunSize {
    std::size_t nodes = 0;
    double pace = 0;               ///< node-steps a second, about
    double bytes_of_snapshot = 0;  ///< as large as it gets while the run ends
    std::size_t probes = 0;        ///< numbers in a row
    double bytes_at_end = 0;       ///< of the field at the end, if it is written
};

class StoppableRun {
  public:
    virtual ~StoppableRun() = default;
    StoppableRun(const StoppableRun&) = delete;
    StoppableRun& operator=(const StoppableRun&) = delete;
    StoppableRun(StoppableRun&&) = delete;
    StoppableRun& operator=(StoppableRun&&) = delete;

    /// Throws Interrupted (what was computed up to there is written, and a checkpoint), Unstable
    /// (the energies up to there are), FileError (it says whether there is a checkpoint to go on
    /// from), and as the body does.
    void to_the_end();

    /// Throws SceneError where its steps take a hundred years, FileError where there is no room for
    /// its files.
    void require_possible(const RunSize& size) const;

    StepsLeft steps_left(const RunSize& size) const;

    /// Prints these on stderr, a line each, and what its user may not expect of any run of this
    /// size.
    void warn(std::vector<std::string> warnings, const RunSize& size) const;

  protected:
    /// About so many rows of energies are printed.
    static constexpr std::size_t printed_rows = 12;
    /// Steps between two looks at the energy: whatever is written, the peak is the same.
    static constexpr std::size_t look_every = 10;

    StoppableRun(const AnyScene& scene, const RunOptions& options);

    /// Takes the name of the scene's files for this run. Gives the checkpoint that it goes on from,
    /// without the highlights, which are this run's then; nothing where it starts. identity: as
    /// identity_of() has it. Throws SceneError for a checkpoint of another scene, and FileError.
    std::optional<Checkpoint> claim(std::map<std::string, std::string> identity,
                                    const StepPlan& plan);

    // The body:
    virtual std::size_t steps() const = 0;
    virtual double time() const = 0;
    virtual void advance(std::size_t steps) = 0;
    /// All that it goes on from, but for the steps.
    virtual std::vector<std::vector<double>> state() const = 0;
    /// Before the first step.
    virtual void begin() = 0;
    /// At every step that is a row or a multiple of look_every, and at the last. Throws Unstable.
    virtual void look(bool is_row) = 0;
    virtual void take_snapshot() = 0;
    virtual RunFiles& files() = 0;
    /// at_end: of a whole run.
    virtual void publish(bool at_end) = 0;

    /// Enters an energy, which a source has fed since the last look or not: whether it has grown
    /// tenfold since none does. That is as unstable as one that is not finite, which the energies
    /// are long before the fields. What a source gave since the last look is in this energy alone,
    /// so that this one counts as driven. Its body looks at what leapfrog keeps, too, which does
    /// not swing, over what was put in: of a plane that is all its sources' work, part of it in
    /// layers beside the nodes this energy is of; of a chain ends put in some, too, which nothing
    /// tells from what an unstable end adds, and the peak while it was driven has to do.
    bool has_grown(double energy, bool is_driven);
    /// Whether this energy is ten times the largest that was entered as driven.
    bool has_grown_since_driven(double energy) const;
    /// "the energy has grown to .. times .."; has_sources: beside an initial field.
    std::string growth(double energy, bool has_sources) const;

    std::string place() const;
    const Highlights& highlights() const { return highlights_; }
    Highlights& highlights() { return highlights_; }
    const RunOptions& options() const { return options_; }
    const std::filesystem::path& checkpoint() const { return checkpoint_; }

  private:
    /// What a run with a later end goes on from, without the last row where that run has none.
    struct End {
        Highlights highlights;
        std::vector<Journal::Mark> journals;
    };

    /// Still to be written.
    Output output_of(const RunSize& size) const;
    double free_bytes() const;

    bool is_done() const { return steps() >= plan_.steps; }
    std::size_t next_stop() const;
    void go_on();
    void step();
    void add_last_row();
    void stop();
    void store();
    void publish_end();
    [[noreturn]] void end_unstable(const Unstable& unstable);
    void go_on_and_publish();
    void clean_up();

    std::size_t every_;
    std::size_t snapshots_;
    double unit_of_time_;
    double pause_;  // between two checkpoints [s]
    RunOptions options_;
    std::string name_;
    std::filesystem::path checkpoint_;
    std::map<std::string, std::string> identity_{};
    StepPlan plan_{};
    std::optional<RunLock> lock_{};
    Highlights highlights_{};
    std::optional<End> end_{};
    bool is_stored_ = false;         // whether the checkpoint is one of this run
    bool replaces_earlier_ = false;  // whether it is of one that cannot go on then
};

}  // namespace nmbcrun
