// SPDX-License-Identifier: MIT
/// Modes of one side of a half plane that grow by themselves, however far the opposite side is.
///
/// A motion exp(s t), Re s > 0, at a wave number along the side is a sum of the decaying modes
/// U z^I (plane_modes.hpp). It exists where their conditions on the ghost layers are linearly
/// dependent: det[Delta_a(s, z_o) U_oa z_o^-M] = 0, rows (M, a), columns o. Over the determinant of
/// ghost layers with u = 0, which has no zero as they keep the energy, that is
///     f(s) = det[Delta_a(s, z_o) U_oa z_o^-M]/det[U_oa z_o^-M].
/// f depends neither on the scale nor on the order of the modes, and is analytic where Re s > 0. So
/// its argument along a line Re s = const counts its zeros beyond. Where both components share
/// Delta, f is the product of Delta(s, z_o). That of absorbs() at a speed > 0 and a shift >= 0 is 0
/// at
///     s = -shift - 2 speed (1 - z)/(1 + z),
/// where Re s < 0 for |z| < 1: a product of such factors has no growing mode, whatever the lattice.
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
/// both counted. f is followed in steps that are halved until it changes little in each: a mode may
/// be missed whose rate is below a hundredth of the highest frequency, if fixed ghost layers have
/// one of that frequency, too. Nothing where modes cannot be told from each other, or one grows at
/// the very rate.
std::optional<std::size_t> growing_modes(const LateralChain& chain, const SideCondition& condition,
                                         double rate);

/// The largest rate of a mode of the side, to 0.5 % from below, where it is above `least`; else
/// `least`. Rates below a millionth of the highest frequency are taken for 0, or up to a thousandth
/// where modes cannot be told; nothing where they cannot be told there, either.
std::optional<double> growth_of_side(const LateralChain& chain, const SideCondition& condition,
                                     double least = 0);

}  // namespace nmbcgen
