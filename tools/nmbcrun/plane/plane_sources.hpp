// SPDX-License-Identifier: MIT
/// What moves the nodes of a plane scene.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tools/nmbcrun/plane/plane_lattice.hpp"
#include "tools/nmbcrun/plane/plane_scene.hpp"
#include "tools/nmbcrun/sources/force_in_time.hpp"
#include "tools/nmbcrun/stepping/plane_stepping.hpp"

namespace nmbcrun {

/// The loads, the force and the drive of a scene, in every step before the sides.
class PlaneSources {
  public:
    /// extension: nodes before the scene's own, along x and y. Throws SceneError where a source
    /// acts on no node, FileError where its file cannot be read.
    PlaneSources(const PlaneScene& scene, const nmbc::Plane& plane,
                 const std::array<std::size_t, 2>& extension, double time_step);

    /// Adds what the forces at `time` change v by in `duration`.
    void push(nmbc::Plane& plane, double time, double duration) const;

    /// time: the end of the step.
    void operator()(nmbc::Plane& plane, double time);

    /// To be called with the velocities that a run begins or goes on with, and the work up to
    /// there.
    void start(const nmbc::Plane& plane, double work = 0);

    /// Done on the body since the start: of leapfrog, an impulse times the mean of the velocities
    /// before and after.
    double work() const { return work_; }

    bool drives(double time) const;

    struct LoadedNodes {
        std::string table{};                 ///< of the scene
        std::vector<std::size_t> entries{};  ///< of a field
    };
    /// The nodes of each source.
    std::vector<LoadedNodes> loaded() const;

    /// In words: what the run misses of the force and of loads from files.
    const std::vector<std::string>& warnings() const { return warnings_; }

  private:
    /// A node that a source moves, in one direction.
    struct Moved {
        std::size_t component = 0;
        std::size_t entry = 0;
        double mass = 0;       ///< per thickness
        double before = 0;     ///< its velocity after the last step
        double kicked = 0;     ///< and after the kick of this one
        std::string course{};  ///< the table of the scene that gives its course
    };
    /// What acts on some of them.
    struct Source {
        std::string table{};  ///< of the scene
        Given given = Given::force;
        std::function<double(double)> at{};  ///< in time
        double last = 0;                     ///< it acts up to this time
        std::vector<std::size_t> nodes{};    ///< places in moved_
        std::vector<double> shares{};        ///< what they have of a force; none: all of it
    };

    using Entries = std::vector<std::size_t>;

    static Source source_of(const PlaneLoad& load);  ///< without a file
    static Source source_of(const PlaneDrive& drive);
    /// With what the run misses of it for the user.
    Source source_of(const ForceInTime& force, const std::vector<std::string>& warnings);
    /// table: of the scene, that acts on these entries of a field. Throws SceneError where
    /// another table gives a course to one of them.
    void add(Source source, std::size_t component, const Entries& entries, const std::string& table,
             const nmbc::Plane& plane);

    std::vector<Source> sources_{};  // later ones have the last word
    std::vector<std::string> warnings_{};
    std::vector<Moved> moved_{};
    std::map<std::array<std::size_t, 2>, std::size_t> places_{};  // there, by component and entry
    double density_;
    double time_step_;
    double work_ = 0;
};

}  // namespace nmbcrun
