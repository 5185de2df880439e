// SPDX-License-Identifier: MIT
/// Higdon's product of one-way wave equations, on every ghost layer.
#pragma once

#include <memory>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/lattice.hpp>
#include <type_traits>

namespace nmbcrun {

/// Of order P, K the shift by a node inwards and Z^-1 the one by a step back, by the box scheme:
///     [(1 + K)/2 (1 - Z^-1)/dt - (c/dX) (K - 1) (1 + Z^-1)/2]^P u = 0,
/// at each ghost node from the innermost outwards, all speeds c = sqrt(E/rho). Order 1 is (58) with
/// midpoint ghosts, NMBC1 of stride 1.
///
/// It knows the continuum, not the lattice, and has no certificate. Every polynomial of degree P -
/// 1 in x and t satisfies it, u = t for one at order 2, so that roundings eps make u grow by about
/// eps^(1/P) a step. In lattices with backward waves (group and phase velocity opposed) it reflects
/// these amplified from order 2 on, and grows (tests/compare/exam_long_run.cpp).
struct HigdonEnd {
    int order = 1;

    static constexpr int highest_order = 10;

    /// Throws std::invalid_argument for an order that is not 1 .. highest_order.
    /// What the end remembers: u at the P - 1 levels before, the latest first, on the ghosts and P
    /// nodes more.
    std::unique_ptr<nmbc::BoundaryCondition<double>> make(
        const nmbc::Lattice& lattice, const nmbc::ChainParameters& parameters,
        std::type_identity<double> precision) const;
};

}  // namespace nmbcrun
