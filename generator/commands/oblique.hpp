// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen oblique: NMBC1 of a plane's side matched at an angle, and products of two.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/commands/direction.hpp"
#include "generator/names/projected_family.hpp"

namespace nmbcgen {

/// A long wave that one factor absorbs.
struct ObliqueWave {
    Polarisation polarisation = Polarisation::P;
    Direction direction{};  ///< from the normal of the side, below 90 degrees
};

struct ObliqueTask {
    std::string family = "nopd2d";
    VectorChoice choice;
    std::vector<ObliqueWave> waves;   ///< one or two
    std::optional<Rational> decay{};  ///< e [dX sqrt(E/density)]; none: the usual one
};

/// The product over the waves of (D + e)(1 + Z) - b (Z - 1), D = d/dt, Z the shift by a node
/// inwards, b = 2 c/(dX cos(angle)): (85) of Nicely 2018, corrected. A product without e keeps a
/// drift, u_tt = 0, so that e is 1/500 unless it is given; one factor needs none. For people, or
/// JSON (docs/reference/json-other.md). Throws NoProjection where c^2 is not rational
/// (plane/plane_taylor.hpp).
std::string oblique_text(const ObliqueTask& task);
std::string oblique_json(const ObliqueTask& task);

}  // namespace nmbcgen
