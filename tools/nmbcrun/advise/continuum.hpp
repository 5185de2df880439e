// SPDX-License-Identifier: MIT
/// What the wave equation makes of a scene's sources: what its lattice is an approximation to,
/// where horizon or G is "auto".
#pragma once

#include <complex>
#include <vector>

#include "tools/nmbcrun/advise/outgoing.hpp"
#include "tools/nmbcrun/advise/pause.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Waves of u_tt = c^2 u_xx, as those of an Outgoing.
struct ContinuumWaves {
    std::vector<std::complex<double>> forwards;
    std::vector<std::complex<double>> backwards;
};

/// The waves under way at outgoing.duration, at its wave numbers. Sources have the values that the
/// scene gives its nodes, and nothing between the nodes that these do not resolve; the nodes
/// between the outermost of a drive move as it prescribes, and waves go out from these two.
ContinuumWaves continuum_waves(const Scene& scene, const Outgoing& outgoing, const Pause& pause);

}  // namespace nmbcrun
