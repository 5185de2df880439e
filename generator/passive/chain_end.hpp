// SPDX-License-Identifier: MIT
/// A passive end of a chain: an edge of one dimension. Units dX = c = density = 1.
#pragma once

#include <functional>
#include <nmbc/passive.hpp>
#include <vector>

#include "generator/passive/design.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// The squares of the energy of a node so many nodes from the end.
using ChainEdge = std::function<std::vector<ExactSquare>(unsigned layer)>;

/// A chain of this symbol: waves see it as layers of one component.
LateralChain chain_of(const std::vector<double>& symbol);

/// Designs of larger horizons take too long.
inline constexpr unsigned largest_designed_horizon = 6;

/// Designed for waves with xi up to 1/dX, longer ones counting more; what it reflects vanishes with
/// xi. Made for leapfrog steps of this length [dX/c]; 0: for continuous time. The symbol is that of
/// the chain's at_edge at this G. Throws std::domain_error where no design is found.
DesignedSide passive_end(const std::vector<double>& symbol, unsigned horizon, const Rational& G,
                         const ChainEdge& at_edge, double time_step);

/// Of the chain of atoms, in closed form: |R| ~ xi^4, two layers, beyond which all is the chain's;
/// without `design`.
DesignedSide atom_chain_end();

/// A designed end as the runtime takes it, with 4n nodes more for what decays beside it. Its
/// highest eigenvalue is said 1 % higher than it was found.
nmbc::PassiveEnd for_runtime(const DesignedSide& side, const EdgeEnergies& energies);

}  // namespace nmbcgen
