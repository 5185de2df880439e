// SPDX-License-Identifier: MIT
/// What the zeros of C, B and s C - B tell: boundary modes, and where in the band to look closely.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "generator/stability/half_space.hpp"

namespace nmbcgen {

/// The fastest growing boundary mode: its s [c/dX], in time steps its sigma, if there is one.
std::optional<std::complex<double>> growing_mode(const HalfSpace& half_space);

/// The wave number of a resonance other than at a band edge, if there is one.
std::optional<double> resonance(const HalfSpace& half_space);

/// The frequencies at which R(omega) can change its character: extrema of omega(xi), zeros of B
/// and of C on the unit circle, and 0; ascending, the largest is the top of the band.
std::vector<double> critical_frequencies(const HalfSpace& half_space);

}  // namespace nmbcgen
