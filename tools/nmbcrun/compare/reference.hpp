// SPDX-License-Identifier: MIT
/// A scene beside the same one without artificial ends.
#pragma once

#include <cstddef>
#include <span>

#include "tools/nmbcrun/simulation/simulation.hpp"

namespace nmbcrun {

/// The scene in steps of time_step [time], with its artificial ends so far away that nothing
/// returns from them. Physical ends stay.
Scene endless(Scene scene, double time_step);

/// The scene with a mirror, about the same surface, in the place of every other closure: half of a
/// longer chain.
Scene with_mirrors(Scene scene);

/// Interior displacements of a chain.
std::span<const double> interior(const nmbc::Chain& chain);

/// The largest difference between the interiors of two chains over a run.
class Deviation {
  public:
    /// To be called after every step of both; they have as many interior nodes.
    void look(const nmbc::Chain& chain, const nmbc::Chain& reference);

    /// max |u - u_ref| / max |u_ref| over all nodes and times seen; infinite where u was not
    /// finite, 0 where u_ref and u were 0 throughout.
    double relative() const;
    std::size_t node() const { return node_; }  ///< where it was largest, interior, from 1
    double time() const { return time_; }       ///< and when

  private:
    double largest_ = 0;
    double reference_ = 0;
    double time_ = 0;
    std::size_t node_ = 0;
};

}  // namespace nmbcrun
