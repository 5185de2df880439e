// SPDX-License-Identifier: MIT
/// Whether no wave is amplified at any frequency of the band, at every G and every step of a box:
/// the waves of each frequency by themselves (wave_grade.hpp).
#pragma once

#include "generator/enclosures/condition.hpp"
#include "generator/table/certificate.hpp"

namespace nmbcgen {

/// tau: as in condition.hpp. By subdivision of the frequencies and of tau into boxes, at most so
/// many; false where that is undecided.
bool waves_have_grade(const EnclosedCondition& condition, const Interval& tau, Grade least,
                      int most_boxes);

/// The largest value of the band.
Interval highest_square(const Expansion& band);

/// How far the band is unknown, in parts of its largest value: finer subdivision does not help.
double spread_of(const Expansion& band);

}  // namespace nmbcgen
