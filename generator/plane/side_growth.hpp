// SPDX-License-Identifier: MIT
/// Modes of one side of a half plane that grow by themselves, however far the opposite side is.
///
/// A motion exp(s t), Re s > 0, at a wave number along the side is a sum of the decaying modes
/// U z^I (plane_modes.hpp), and exists where their conditions on the ghost layers are linearly
/// dependent. Against fixed ghost layers, which keep the energy so that none grows, that is
///     f(s) = det[Delta_a(s, z_o) U_oa z_o^-M]/det[U_oa z_o^-M] = 0,
/// rows (M, a), columns o. f depends neither on the scale nor the order of the modes, and is
/// analytic where Re s > 0, so that its argument along a line Re s = const counts its zeros beyond.
/// Where both components share Delta, f is the product of Delta(s, z_o). That of absorbs() at a
/// speed > 0 is 0 where
///     s = -shift - 2 speed (1 - z)/(1 + z),
/// which has no Re s > 0 at |z| < 1: no product of such factors has a growing mode, at any side.
#pragma once

#include <complex>
#include <cstddef>
#include <optional>

#include "generator/plane/plane_lattice.hpp"
#include "generator/plane/side_condition.hpp"

namespace nmbcgen {

/// f(s).
std::complex<double> growth_determinant(const LateralChain& chain, const SideCondition& condition,
                                        std::complex<double> s);

/// How many modes of the side grow faster than a rate > 0 in continuous time, those at conjugate s
/// both counted. f is followed in steps that are halved until it changes little in each. Nothing
/// where that does not end: modes cannot be told from each other, or one grows at the very rate.
std::optional<std::size_t> growing_modes(const LateralChain& chain, const SideCondition& condition,
                                         double rate);

/// The largest rate of a mode of the side, found to half a hundredth, where it is above `least`;
/// else, or where modes cannot be told, `least`. A rate below a millionth of the highest frequency
/// is taken for 0.
double growth_of_side(const LateralChain& chain, const SideCondition& condition, double least = 0);

}  // namespace nmbcgen
