// SPDX-License-Identifier: MIT
/// Chains of a scene without its sources.
#pragma once

#include <nmbc/chain.hpp>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// The scene's lattice in its own step, which it has, with such ends.
nmbc::Chain chain_between(const Scene& scene, const nmbc::ChainEnd& left,
                          const nmbc::ChainEnd& right);

}  // namespace nmbcrun
