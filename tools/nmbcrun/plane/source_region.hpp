// SPDX-License-Identifier: MIT
/// The nodes of a plane that a source acts on, but for those of a side.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "tools/nmbcrun/plane/plane_scene.hpp"
#include "tools/nmbcrun/stepping/plane_stepping.hpp"

namespace nmbcrun {

/// The field's entries of nodes in a region.
struct PickedNodes {
    std::vector<std::size_t> entries{};
    std::vector<double> shares{};  ///< what they have of a force; none: all of it
    std::vector<bool> between{};   ///< NodeShare::is_between; none: all of them

    /// Those that have all of it and lie between the nodes chosen: what gives a course to nodes
    /// gives it to these. Beyond them, up to a mirror, a course would hold what is free to move.
    /// Throws SceneError naming the table where there are none.
    std::vector<std::size_t> whole(const std::string& table) const;
};

/// The scene's nodes in a region; of a scene with an original, those about its nodes there. Throws
/// SceneError where there are none, naming the nearest node and the half_width that reaches it.
class SourceRegion {
  public:
    /// extension: as PlaneSources has it. All three outlive it.
    SourceRegion(const PlaneScene& scene, const nmbc::Plane& plane,
                 const std::array<std::size_t, 2>& extension)
        : own_(scene),
          scene_(scene.original ? *scene.original->scene : scene),
          plane_(plane),
          extension_(extension) {}

    /// The region of a table of the scene: a disc [length].
    PickedNodes within(const std::string& table, const std::array<double, 2>& centre,
                       double radius) const;

    /// Likewise, a rectangle.
    PickedNodes within(const std::string& table, const std::array<double, 2>& centre,
                       const std::array<double, 2>& half_width) const;

  private:
    double more() const;
    template <class IsWithin, class HalfWidth>
    PickedNodes nodes_where(const IsWithin& is_within, const std::string& table,
                            const std::array<double, 2>& centre, const HalfWidth& half_width) const;
    PickedNodes picked(const std::vector<bool>& chosen) const;

    const PlaneScene& own_;
    const PlaneScene& scene_;  // on whose nodes sources are given
    const nmbc::Plane& plane_;
    const std::array<std::size_t, 2>& extension_;
};

}  // namespace nmbcrun
