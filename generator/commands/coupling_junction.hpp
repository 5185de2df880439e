// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen coupling stencil, junction: rows of the stiffness in exact numbers.
#pragma once

#include <string>

#include "generator/coupling/mesh.hpp"

namespace nmbcgen {

/// Of a uniform bar [h]: the row of a node from the diagonal outwards.
std::string stencil_text(const Rational& horizon);
std::string stencil_json(const Rational& horizon);

/// Of two bars: the rows that are neither bar's own, in either form.
std::string junction_text(const Halves& halves);
std::string junction_json(const Halves& halves);

}  // namespace nmbcgen
