// SPDX-License-Identifier: MIT
/// Whether no boundary mode grows, at every G and every step of a box.
#pragma once

#include "generator/enclosures/condition.hpp"

namespace nmbcgen {

/// All k of sigma C = B are among the roots of a real polynomial in w or in v (condition.hpp),
/// which are in discs (root_discs.hpp).
/// A root alone in a disc about a real number is real, and travels if w <= 0. For all others Re
/// sigma < 0 is, without a factor Re y that vanishes towards travelling waves,
///     Re O conj(E) - (|w| - Re w) Im(O conj(E))/Im w > 0,
/// and in v the same with minus (|(3v+1)^2 - v^2| + |v|^2 - |3v+1|^2)/2 in place of |w| - Re w. Of
/// those that travel, waves_have_grade() tells that none leaves the boundary without having come.
/// tau: as in condition.hpp. By subdivision of tau; false where that is undecided.
bool no_mode_grows(const EnclosedCondition& condition, const Interval& tau);

}  // namespace nmbcgen
