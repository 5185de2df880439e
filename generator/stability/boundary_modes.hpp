// SPDX-License-Identifier: MIT
/// What the zeros of C, B and s C - B tell: boundary modes, and where in the band to look closely.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "generator/stability/half_space.hpp"

namespace nmbcgen {

/// The waves that obey the boundary condition by themselves.
class BoundaryModes {
  public:
    explicit BoundaryModes(const HalfSpace& half_space);  ///< which has to live as long

    /// The fastest growing one: its s [c/dX], in time steps its sigma, if there is one.
    std::optional<std::complex<double>> growing() const;

    /// The wave number of a resonance other than at a band edge, if there is one.
    std::optional<double> resonance() const;

  private:
    const HalfSpace& half_space_;
    IntegerPolynomial modes_;
    std::vector<std::complex<double>> zeros_;  ///< its own: w, of a damped lattice y
};

inline std::optional<std::complex<double>> growing_mode(const HalfSpace& half_space) {
    return BoundaryModes(half_space).growing();
}

/// The frequencies at which R(omega) can change its character: extrema of omega(xi), zeros of B
/// and of C on the unit circle, and 0; ascending, the largest is the top of the band.
std::vector<double> critical_frequencies(const HalfSpace& half_space);

}  // namespace nmbcgen
