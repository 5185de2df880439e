// SPDX-License-Identifier: MIT
/// Passive sides, designed for the lattice of a plane scene.
#pragma once

#include <nmbc/plane_sides.hpp>

#include "generator/passive/plane_side.hpp"
#include "tools/nmbcrun/plane/plane_scene.hpp"

namespace nmbcrun {

/// The scene's lattice, which is to have constant influence.
nmbcgen::SideTask side_task_of(const PlaneScene& scene);

struct DesignedPassiveSide {
    nmbcgen::SideTask task;
    nmbcgen::DesignedSide design;
    nmbc::PassiveSide side;  ///< the design as the runtime takes it
};

/// Takes as long as nmbcgen::passive_side(); a terminal shows how far it is, unless quiet.
/// Throws SceneError where there is none for the scene.
DesignedPassiveSide designed_side_of(const PlaneScene& scene, bool quiet);

}  // namespace nmbcrun
