// SPDX-License-Identifier: MIT
/// The body of a plane scene on another lattice, moved by the same sources.
#pragma once

#include <array>
#include <cstddef>

#include "tools/nmbcrun/plane/plane_simulation.hpp"

namespace nmbcrun {

struct SameBody {
    PlaneScene scene;  ///< its steps are those that its sides allow
    nmbc::PlaneSides sides;
};

/// The body of a scene between its own sides, as sides_of() has them, between others instead, on a
/// lattice of the original's spacing over `ratio` and of as many neighbours. It lies where the
/// original's does: up to the outermost nodes of closed sides, dX/2 beyond them at mirrors and free
/// sides, up to the first ghosts of fixed ones. A force goes over linearly from one node of the
/// original to the next, so that it is as large in all, but for volumes of closed sides that are
/// others; what is moved is moved from the outermost of its nodes to the outermost, and not beyond,
/// up to a mirror. Throws SceneError where no such lattice fits the body, it has too many nodes, or
/// the scene asks for what depends on its own lattice, and as sides_of() does.
SameBody same_body(const PlaneScene& original, const nmbc::PlaneSides& own,
                   const std::array<PlaneSideChoice, 4>& sides, std::size_t ratio);

/// The nodes that a simulation's body shares with a body like it on another lattice.
class CommonNodes {
  public:
    /// Throws SceneError where a node of the first is none of the other.
    CommonNodes(const PlaneSimulation& one, const PlaneSimulation& other);

    /// Of components of u [length].
    struct Difference {
        double largest = 0;                    ///< |u - u_other|; not a number where u is not
        std::array<std::ptrdiff_t, 2> node{};  ///< and where: the first's, its scene's from 1 on
        double other = 0;                      ///< largest |u_other|
    };
    /// Of two simulations of these two scenes.
    Difference between(const PlaneSimulation& one, const PlaneSimulation& other) const;

  private:
    std::size_t stride_ = 1;                 // nodes of the other to one of the first
    std::array<std::ptrdiff_t, 2> first_{};  // the other's node that is the first's node 0
};

}  // namespace nmbcrun
