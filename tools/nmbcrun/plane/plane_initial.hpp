// SPDX-License-Identifier: MIT
/// What a plane scene's [initial] gives the nodes.
#pragma once

#include <array>
#include <cstddef>

#include "tools/nmbcrun/plane/plane_scene.hpp"
#include "tools/nmbcrun/plane/start_of_nodes.hpp"
#include "tools/nmbcrun/stepping/plane_stepping.hpp"

namespace nmbcrun {

/// The field of an [initial] that is no file.
class InitialShape {
  public:
    /// Of a scene that has one.
    explicit InitialShape(const PlaneScene& scene);
    /// At a point [length].
    StartOfNode at(const std::array<double, 2>& point) const;

  private:
    PlaneInitial initial_;
    double spacing_;
    // Of a packet's wave:
    std::array<double, 2> xi_{};
    double omega_ = 0;                        // [1/time]
    std::array<double, 2> group_velocity_{};  // [length/time]
    std::array<double, 2> direction_{};       // of u
};

/// Writes u at t = 0 and v of the scene, which has an [initial], to the nodes of its plane, those
/// of layers, too. extension: nodes that extended sides add, in the order of nmbc::plane_sides.
/// Returns whether v is at -dt/2, as in the files of runs, rather than at 0. Throws SceneError
/// where a file is none of this scene, FileError where it cannot be read.
bool set_initial_fields(const PlaneScene& scene, const std::array<std::size_t, 4>& extension,
                        nmbc::Plane& plane);

/// Of each side what is set so on the scene's outermost nodes, u or v: the largest |value|, over
/// that of all its nodes.
std::array<double, 4> initial_at_sides(const PlaneScene& scene,
                                       const std::array<std::size_t, 4>& extension,
                                       const nmbc::Plane& plane);

}  // namespace nmbcrun
