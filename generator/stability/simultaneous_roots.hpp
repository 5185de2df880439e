// SPDX-License-Identifier: MIT
/// All roots of a complex polynomial at once, by the iteration of Ehrlich and Aberth.
#pragma once

#include <complex>
#include <optional>
#include <vector>

namespace nmbcgen {

/// The roots of sum_i a_i x^i, the first and the last coefficient not 0, each to the roundings of
/// the polynomial's value there; none where the iteration does not settle.
///
/// x_i is improved by N/(1 - N sum_{l != i} 1/(x_i - x_l)), N = p/p' at x_i: Newton's step on p
/// with the other roots divided out (Aberth 1973). It begins on circles of the radii that the
/// Newton polygon of the log |a_i| suggests, which finds small roots beside large ones
/// (Bini 1996).
std::optional<std::vector<std::complex<double>>> simultaneous_roots(
    const std::vector<std::complex<double>>& a);

/// Likewise, from such guesses, one for each root and no two alike: those of a polynomial next to
/// it save two thirds of the time.
std::optional<std::vector<std::complex<double>>> simultaneous_roots(
    const std::vector<std::complex<double>>& a, std::vector<std::complex<double>> guesses);

}  // namespace nmbcgen
