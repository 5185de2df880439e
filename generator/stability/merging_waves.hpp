// SPDX-License-Identifier: MIT
/// What waves do between two critical frequencies that are nearly one, as where two extrema of the
/// band meet or change their order. There reflection.hpp tells waves from each other no more, and
/// the divided differences of generator/enclosures/wave_grade.hpp, which stay finite, decide.
#pragma once

#include <vector>

#include "generator/stability/half_space.hpp"
#include "generator/table/certificate.hpp"

namespace nmbcgen {

/// The grade that the narrow pieces (band_search.hpp) between these critical frequencies leave to
/// an undamped half space, in its own step; contractive where there are none. One frequency of each
/// is looked at. Where roundings do not tell which of two extrema is the higher one, the waves of
/// both are taken to travel.
Grade grade_of_narrow_pieces(const HalfSpace& half_space, const std::vector<double>& critical);

}  // namespace nmbcgen
