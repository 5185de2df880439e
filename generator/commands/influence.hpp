// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen influence: bonds whose strength falls as a power of their length.
#pragma once

#include <string>

#include "generator/families/power_influence.hpp"

namespace nmbcgen {

/// What the influence does to waves, and its chain: for people, or JSON
/// (docs/reference/json-other.md).
std::string power_influence_text(const PowerInfluence& influence);
std::string power_influence_json(const PowerInfluence& influence);

/// The same influence on bonds of a square or cubic lattice.
struct ClassInfluence {
    unsigned power = 0;           ///< p
    Rational smoothing = 1;       ///< eps [dX]
    unsigned radius_squared = 0;  ///< delta^2 [dX^2]; 0: of a chain
    std::size_t dimensions = 2;   ///< or 3
};

/// Its weights as options of lattice families. Throws NoSuchModel for a radius that there is not,
/// and as class_weights().
std::string class_influence_text(const ClassInfluence& influence);
std::string class_influence_json(const ClassInfluence& influence);

}  // namespace nmbcgen
