// SPDX-License-Identifier: MIT
/// Summation by parts: a true end of a correspondence chain whose strains pass the patch test. The
/// outermost node lies on the surface. Units: dX = E = density = 1.
#pragma once

#include <span>
#include <vector>

#include "generator/table/exact.hpp"

namespace nmbcgen {

/// V D = Q with Q + Q^T = diag(-1, 0, .., 0, 1), Q 1 = 0, Q x = V 1 of a chain whose strain inside
/// is D u = sum_k inside_k (u_{I+k} - u_{I-k}), k = 1 .. n. Nodes are counted from the surface, 0.
struct SummationByParts {
    std::vector<Rational> inside;             ///< inside_1 .. inside_n
    std::vector<Rational> volumes;            ///< V of the n outermost nodes; all others have 1
    std::vector<std::vector<Rational>> rows;  ///< of Q, of these nodes, on nodes 0 .. 2n-1
};

/// Of the influence w_1 .. w_n. Q is free in (n-1)(n-2)/2 numbers: its entries between the n
/// outermost nodes are those with the least sum of squared differences from the lattice's own.
/// Where D_I is the sum that a row of the lattice's own Q falls short of 0,
///     Q_IJ = inside_{J-I} + (D_I - D_J)/n.
/// Throws std::domain_error where a volume is not positive.
SummationByParts summation_by_parts(std::span<const Rational> weights);

}  // namespace nmbcgen
