// SPDX-License-Identifier: MIT
/// nopd1d of constant influence where families are cut off.
#pragma once

#include <nmbc/lattice.hpp>
#include <vector>

namespace nmbcrun {

/// All squares of the energy of a node whose family is the offsets first .. n.
std::vector<nmbc::Lattice::Square> squares_of(int first, int n, double G);

/// G of such a lattice. Throws std::invalid_argument for another one, or a damped one.
double stabilisation_of(const nmbc::Lattice& lattice);

}  // namespace nmbcrun
