// SPDX-License-Identifier: MIT
/// Layers at their best for a scene: what a user who spares no trouble would find.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "tools/nmbcrun/chart/trial.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

struct Losses {
    double profile = 2;    ///< their exponent in the depth of the layer
    double target = 0.01;  ///< amplitude that the continuum sends back
};

/// Those of one of the profiles and a target from 1e-10 to 0.9 with the least error, in so many
/// calls at most. The target has three digits.
Losses least_erring_losses(std::span<const double> profiles, std::size_t runs,
                           const std::function<double(const Losses&)>& error_of);

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
