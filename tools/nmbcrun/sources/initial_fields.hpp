// SPDX-License-Identifier: MIT
/// What a scene's [initial] gives the nodes.
#pragma once

#include <cstddef>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/lattice.hpp>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

struct InitialFields {
    std::vector<double> u;      ///< at t = 0, of all nodes
    std::vector<double> v;      ///< of all nodes,
    bool is_staggered = false;  ///< at t = -dt/2 rather than 0
};

/// nodes: all of the chain's; first_interior: entry of the first interior one. Where the scene has
/// no [initial], zeros. A pulse is there on ghosts and layers, too, a file on interior nodes only.
/// Throws SceneError where a wave's width is out of bounds or the file is not of this chain,
/// FileError where it cannot be read.
InitialFields initial_fields(const Scene& scene, const nmbc::Lattice& lattice,
                             const nmbc::ChainParameters& parameters, std::size_t nodes,
                             std::size_t first_interior);

}  // namespace nmbcrun
