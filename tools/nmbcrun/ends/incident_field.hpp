// SPDX-License-Identifier: MIT
/// A field that an end lets in: its condition acts on what is there besides.
#pragma once

#include <memory>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/node_line.hpp>
#include <type_traits>
#include <vector>

#include "tools/nmbcrun/ends/lattice_wave.hpp"

namespace nmbcrun {

/// u_b, which solves the chain's own equations without any source: a homogeneous deformation, and
/// waves.
struct IncidentField {
    double per_node = 0;  ///< of the deformation: u from a node to the next [length]
    double middle = 0;    ///< where it has u = 0 [dX; node 1 is at 1]
    std::vector<LatticeWave> waves{};
    double origin = 0;     ///< of the waves' x [dX; node 1 is at 1]
    double arrival = 0;    ///< the waves' step 0, in steps of the chain
    double inside = 0;     ///< at t = 0 none of them is further in than this [dX]
    double last_wave = 0;  ///< the step of the chain from which on there are none
};

/// Another end, whose condition acts on u - u_b and v - v_b. They are taken off the ghosts, the
/// layer and as many interior nodes as that end says it needs, which it must not read beyond.
/// start() is for v at -dt/2 of the first step: a state that is written to later on is not for it.
struct IncidentFieldEnd {
    nmbc::ChainEnd inner;
    nmbc::End end;
    std::shared_ptr<const IncidentField> incident;

    std::unique_ptr<nmbc::BoundaryCondition<double>> make(
        const nmbc::Lattice& lattice, const nmbc::ChainParameters& parameters,
        std::type_identity<double> precision) const;
};

}  // namespace nmbcrun
