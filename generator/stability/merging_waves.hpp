// SPDX-License-Identifier: MIT
/// What waves do between two critical frequencies that are nearly one, as where two extrema of the
/// band meet or change their order. There reflection.hpp tells waves from each other no more, and
/// the divided differences of generator/enclosures/wave_grade.hpp, which stay finite, decide.
#pragma once

#include <vector>

#include "generator/stability/half_space.hpp"
#include "generator/table/certificate.hpp"

namespace nmbcgen {

struct NarrowPieces {
    Grade grade = Grade::contractive;  ///< what they leave to a half space
    double omega = 0;                  ///< in the piece that leaves no more; 0: none takes any
};

/// The narrow pieces (band_search.hpp) between these critical frequencies of an undamped half
/// space, in its own step. One frequency of each is looked at. Where roundings do not tell which of
/// two extrema is the higher one, the waves of both are taken to travel.
NarrowPieces grade_of_narrow_pieces(const HalfSpace& half_space,
                                    const std::vector<double>& critical);

}  // namespace nmbcgen
