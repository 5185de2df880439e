// SPDX-License-Identifier: MIT
/// A strip of a plane lattice, so many layers wide and endless along its two sides.
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "generator/plane/side_condition.hpp"

namespace nmbcgen {

/// A side where an undamped lattice is cut off, at one wave number along it: what is cut and where
/// masses are those of the interior.
struct CutSide {
    /// Of the outermost layers, at least of those whose forces are not the interior's. Components
    /// as in LateralChain, x inwards; columns are layers from the side inwards.
    Eigen::MatrixXd stiffness;
};

using StripSide = std::variant<SideCondition, CutSide>;

struct Strip {
    StripSide left;
    StripSide right;
    std::size_t layers = 20;  ///< no fewer than a condition looks at inwards, or a cut changes
    double time_step = 0;     ///< of leapfrog steps (leapfrog.hpp) [dX sqrt(rho/E)]; 0: none
};

/// The largest real part of s [sqrt(E/rho)/dX] over all motions exp(s t + i k_t y) of a strip of
/// this chain: positive where it is not stable. Static states have s = 0, up to the roundings of a
/// multiple eigenvalue.
double growth_in_strip(const LateralChain& chain, const Strip& strip);

/// k_t in so many equal steps from 0 to pi, and the first of them halved up to five times.
std::vector<double> strip_wave_numbers(std::size_t steps);

}  // namespace nmbcgen
