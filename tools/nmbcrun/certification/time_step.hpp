// SPDX-License-Identifier: MIT
/// The time step of a scene that gives none.
#pragma once

#include <algorithm>
#include <cstddef>
#include <nmbc/lattice.hpp>
#include <string>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// The top of the band of a scene's lattice, in the scene's units [1/time].
double highest_frequency(const Scene& scene, const nmbc::Lattice& lattice);

/// The largest cfl in which no mode beside each end grows: its surface's, or the interior's.
struct SurfaceLimits {
    double left = 0;
    double right = 0;

    double least() const { return std::min(left, right); }
};

/// Of all that goes into the choice of a step, this takes longest. It does not depend on the step.
SurfaceLimits surface_limits(const Scene& scene, const nmbc::Lattice& lattice);

struct AutomaticStep {
    double cfl = 0;       ///< dt omega_max / 2
    std::string limit{};  ///< what does not allow a longer one, in words
    double from = 0;      ///< the smallest cfl that the ends' tables are certified for
};

/// The step that an end of the scene is matched in; without one, the largest that is certified for
/// the ends, but a twentieth of shortest_time_scale() at most.
/// Like ends: as their table has it. Unlike ones: the least of their tables' own, and from there
/// down in steps of 0.05 of cfl until the two are certified together.
/// omega_max [1/time]: the top of the lattice's band. surfaces: as surface_limits() has them.
/// Throws Unstable where no step is certified, or not the one that an end is matched in, unless
/// boundary.allow_unstable.
AutomaticStep automatic_step(const Scene& scene, const nmbc::Lattice& lattice, double omega_max,
                             const SurfaceLimits& surfaces);

/// The largest cfl at which the scene's ends are certified, as automatic_step() seeks it; 0: none.
double largest_certified_cfl(const Scene& scene, const nmbc::Lattice& lattice);

/// Which steps are told to take in place of such that are too long.
enum class OfEnds {
    any,       ///< those in which interior and true ends are stable
    certified  ///< of them, those that the scene's ends are certified for
};

/// In words, with the key that gives them, where the interior, or a mode beside a true end, is not
/// stable in such steps [time], whatever is allowed; empty where both are.
std::string objection_to_steps(const Scene& scene, const nmbc::Lattice& lattice, double time_step,
                               const SurfaceLimits& surfaces, OfEnds of_ends);

/// Throws SceneError where an end is matched in another time step [time], or without midpoint
/// ghosts.
void require_matched(const Scene& scene, double time_step);

}  // namespace nmbcrun
