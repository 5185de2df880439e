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

}  // namespace nmbcgen
