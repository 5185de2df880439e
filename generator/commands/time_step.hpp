// SPDX-License-Identifier: GPL-2.0-or-later
/// Time steps of a lattice at one G, in terms of cfl = dt omega_max / 2.
#pragma once

#include "generator/table/table.hpp"

namespace nmbcgen {

/// omega_max [c/dX], the top of the undamped band, of the lattice that is specified with its G.
double maximum_frequency(const Specification& specification);

/// The largest multiple of 1/1000 dX/c that is not above.
Rational time_step_below(double longest);

/// The same of the steps of this cfl. Throws NoSuchBoundary where it is 0.
Rational time_step_at(const Rational& cfl, const Specification& specification);

/// Throws NoSuchBoundary where the specification has a G and a time step that leapfrog itself is
/// not stable in: cfl >= 1, or less where damped.
void require_leapfrog(const Specification& specification);

}  // namespace nmbcgen
