// SPDX-License-Identifier: MIT
/// The ends of a scene, as the chain takes them.
#pragma once

#include <cstddef>
#include <nmbc/boundary_condition.hpp>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Steps that a run between such ends may have at most.
std::size_t most_steps(BoundaryKind kind);

/// Throws SceneError where there is no table for it, nmbc::CoefficientError where its coefficients
/// do not exist at the scene's G. Whether it is stable is certificate.hpp's to say.
nmbc::ChainEnd chain_end(const Scene& scene, const Boundary& boundary);

}  // namespace nmbcrun
