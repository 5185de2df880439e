// SPDX-License-Identifier: MIT
/// What moves the nodes of a plane scene.
#pragma once

#include <array>
#include <cstddef>
#include <nmbc/plane.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tools/nmbcrun/plane/plane_scene.hpp"
#include "tools/nmbcrun/sources/force_in_time.hpp"

namespace nmbcrun {

/// The scene's lattice, without what belongs to its sides.
nmbc::PlaneModel model_of(const PlaneScene& scene);

/// sqrt(E/rho)/dX [1/time].
double rate_of(const PlaneScene& scene);

/// u and v of the start at a point [length].
struct PlaneStart {
    std::array<double, 2> u{};
    std::array<double, 2> v{};
};
class PlaneInitialField {
  public:
    /// Of a scene that has one.
    explicit PlaneInitialField(const PlaneScene& scene);
    PlaneStart at(const std::array<double, 2>& point) const;

  private:
    PlaneInitial initial_;
    double spacing_;
    // Of a packet's wave:
    std::array<double, 2> xi_{};
    double omega_ = 0;                        // [1/time]
    std::array<double, 2> group_velocity_{};  // [length/time]
    std::array<double, 2> direction_{};       // of u
};

/// The force and the drive of a scene, in every step before the sides.
class PlaneSources {
  public:
    /// extension: nodes before the scene's own, along x and y. Throws SceneError where a source
    /// acts on no node, FileError where its file cannot be read.
    PlaneSources(const PlaneScene& scene, const nmbc::Plane& plane,
                 const std::array<std::size_t, 2>& extension, double time_step);

    /// time: the end of the step.
    void operator()(nmbc::Plane& plane, double time);

    /// To be called with the velocities that a run begins or goes on with, and the work up to
    /// there.
    void start(const nmbc::Plane& plane, double work = 0);

    /// Done on the body since the start: of leapfrog, an impulse times the mean of the velocities
    /// before and after.
    double work() const { return work_; }

    bool drives(double time) const;

    std::string warning(double time_step) const {
        return force_in_time_ ? force_in_time_->warning(time_step) : std::string();
    }

  private:
    /// A node that a source moves, in one direction.
    struct Moved {
        std::size_t component = 0;
        std::size_t entry = 0;
        bool is_forced = false;
        bool is_driven = false;
        double before = 0;  ///< its velocity after the last step
    };

    std::optional<ForceInTime> force_in_time_{};
    std::optional<PlaneDrive> drive_;
    std::vector<Moved> moved_{};
    double density_;
    double mass_;  // of a node, per thickness
    double time_step_;
    double work_ = 0;
};

}  // namespace nmbcrun
