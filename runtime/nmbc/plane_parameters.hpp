// SPDX-License-Identifier: MIT
/// What a plane is set up from.
#pragma once

#include <cmath>
#include <cstddef>

namespace nmbc {

/// Physical set-up, in any one consistent system of units.
struct PlaneParameters {
    std::size_t nx = 0;         ///< interior nodes along x
    std::size_t ny = 0;         ///< and along y
    double spacing = 1;         ///< dX [length]
    double youngs_modulus = 1;  ///< E [stress]
    double density = 1;         ///< rho [mass/volume]
    double time_step = 0;       ///< dt [time]

    /// sqrt(E/rho)/dX [1/time]: waves are a little faster than a node per 1/rate.
    double rate() const { return std::sqrt(youngs_modulus / density) / spacing; }
};

}  // namespace nmbc
