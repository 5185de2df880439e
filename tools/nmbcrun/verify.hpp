// SPDX-License-Identifier: MIT
/// nmbcrun verify: how far a scene's ends take it from the same scene without ends.
#pragma once

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Runs the scene beside its reference and prints max |u - u_ref| / max |u_ref| over all interior
/// nodes and steps, the energy left in both, and for wave numbers of the source what each end
/// reflects, measured by packets and predicted. The reference of a scene between true ends has
/// mirrors in the place of other closures. Returns whether the error is within the tolerance.
/// Throws as Simulation does, Unstable where the run becomes non-finite and Interrupted.
bool verify(const Scene& scene, double tolerance, bool quiet);

}  // namespace nmbcrun
