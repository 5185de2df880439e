// SPDX-License-Identifier: MIT
/// Higdon's product of one-way wave equations, on every ghost layer.
#pragma once

#include <memory>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/lattice.hpp>
#include <type_traits>

namespace nmbcrun {

/// nmbc::HigdonCondition of `order` speeds, all c = sqrt(E/rho), without decay.
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
