// SPDX-License-Identifier: MIT
/// What the continuum limit of a family is stated in.
#pragma once

#include "generator/exact/real.hpp"

namespace nmbcgen {

/// A dispersion relation at one wave number xi: omega^2 [(c/dX)^2] and its derivative by xi.
struct SquaredFrequency {
    Real value;
    Real slope;
};

/// The same of P and S waves of a plane, in doubles: omega^2 [E/(rho dX^2)].
struct PlaneLimit {
    double P = 0;
    double P_slope = 0;
    double S = 0;
    double S_slope = 0;
};

}  // namespace nmbcgen
