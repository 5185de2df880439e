// SPDX-License-Identifier: GPL-2.0-or-later
/// How much of a wave's energy a boundary sends back.
#pragma once

#include "generator/stability/half_space.hpp"

namespace nmbcgen {

/// The part of the energy flux of an incident wave of wave number xi [1/dX] that comes back in
/// waves of any wave number. In a damped lattice the wave is the one with the frequency that xi has
/// undamped; only waves that fade by less than a tenth a node count, with the undamped group
/// velocity.
double reflected_energy(const HalfSpace& half_space, double xi);

/// Its mean over wave numbers low .. high, 0 < low < high <= pi.
double mean_reflected_energy(const HalfSpace& half_space, double low, double high);

/// The part of its energy that a wave of so many dX loses in a damped lattice on its way over one
/// wavelength; 0 undamped.
double loss_per_wavelength(const HalfSpace& half_space, double wavelength);

}  // namespace nmbcgen
