// SPDX-License-Identifier: MIT
/// The ends of a scene, as the chain takes them.
#pragma once

#include <cstddef>
#include <nmbc/end_condition.hpp>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Whether a table with its coefficients makes this end.
bool takes_table(BoundaryKind kind);

/// Whether there can be a certificate for a chain with this end.
bool has_certificate(BoundaryKind kind);

/// Steps that a run between such ends may have at most.
std::size_t most_steps(BoundaryKind kind);

/// Throws SceneError where there is no table for it, nmbc::CoefficientError where its coefficients
/// do not exist at the scene's G. Whether it is stable is certificate.hpp's to say.
nmbc::ChainEnd chain_end(const Scene& scene, const Boundary& boundary);

}  // namespace nmbcrun
