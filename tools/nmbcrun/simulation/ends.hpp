// SPDX-License-Identifier: MIT
/// The ends of a scene, as the chain takes them.
#pragma once

#include <cstddef>
#include <nmbc/boundary_condition.hpp>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Steps that a run between such ends may have at most.
std::size_t most_steps(BoundaryKind kind);

/// Throws nmbc::CoefficientError where a coefficient has a pole at the scene's G, of which a double
/// may be a rounding. In exact numbers, which take a hundred times as long as to make the end.
void require_no_pole(const Scene& scene, const Boundary& boundary);

/// Throws SceneError where there is no table for it, nmbc::CoefficientError where its coefficients
/// do not exist at the scene's G, a pole that G is a rounding of apart. Whether it is stable is
/// certificate.hpp's to say.
nmbc::ChainEnd chain_end(const Scene& scene, const Boundary& boundary);

}  // namespace nmbcrun
