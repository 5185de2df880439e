// SPDX-License-Identifier: MIT
/// Layers at their best for a scene: what a user who spares no trouble would find.
#pragma once

#include <cstddef>

#include "tools/nmbcrun/chart/trial.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Runs of the scene that tuned() takes at most.
inline constexpr std::size_t tuning_runs = 60;

/// A sponge or perfectly matched layer of this width with the profile, of 1, 2, 3, 4 and 6, and the
/// target, from 1e-10 to 0.9, that leave the least error of the ends in the scene, which has its
/// step. reference: samples_without_ends() of it. Throws as Simulation does.
Boundary tuned(const Scene& scene, Boundary layer, const Samples& reference,
               const Advance& advance);

/// The narrowest extended end from which no more comes back before the scene is over than 1e-12 of
/// max |u|. Likewise.
Boundary narrowest_silent(const Scene& scene, const Samples& reference, const Advance& advance);

}  // namespace nmbcrun
