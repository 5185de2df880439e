// SPDX-License-Identifier: MIT
/// The matching boundary with the edge effect (Nicely 2018, sections 5 and 5.1, Figs. 6 and 7).
#pragma once

#include <memory>
#include <nmbc/boundary.hpp>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/lattice.hpp>
#include <type_traits>

namespace nmbcrun {

/// Only the n innermost ghost nodes exist; (60) moves them, M = 0 .. n-1. Their families are cut
/// off where the nodes end, and those of interior nodes are whole: at a ghost node I, sums over the
/// nodes J of the family that exist,
///     eps_I = sum (x_J - x_I) (u_J - u_I) / sum (x_J - x_I)^2,
///     z_IJ = u_J - u_I - (x_J - x_I) eps_I   with the weight 2 G / (n^3 number of J),
/// and the force on a node is minus the derivative of the energy of these squares. At n = 1, G = 0
/// the outermost interior node has u_1'' = (4 u_0 - 5 u_1 + u_3)/4 [E/(rho dX^2)]: a bar that is
/// strained evenly does not rest. The outer n of the chain's 2n ghosts are held at 0 and act on
/// nothing.
struct TruncatedEnd {
    nmbc::BoundaryCoefficients coefficients;
    nmbc::GhostRule ghost_rule = nmbc::GhostRule::midpoint;

    /// Throws std::invalid_argument for other lattices than nopd1d of constant influence, for
    /// damped ones, and as MatchingBoundary does.
    std::unique_ptr<nmbc::BoundaryCondition<double>> make(
        const nmbc::Lattice& lattice, const nmbc::ChainParameters& parameters,
        std::type_identity<double> precision) const;
};

}  // namespace nmbcrun
