// SPDX-License-Identifier: MIT
/// How much of a wave's energy a boundary sends back.
#pragma once

#include "generator/stability/reflection.hpp"

namespace nmbcgen {

/// What a boundary makes of one incident wave, at the frequency that xi has undamped.
struct ReflectedWave {
    Reflection reflection;
    Eigen::Index incident;  ///< its column: the wave whose wave number is next to xi
    /// For each outgoing wave, the part of the incident energy flux that it carries. In a damped
    /// lattice only waves that fade by less than a tenth a node count, with the undamped group
    /// velocity.
    std::vector<double> energy_flux;
};

/// xi [1/dX] in (0, pi).
ReflectedWave reflected_wave(const HalfSpace& half_space, double xi);

/// The part of the energy flux of an incident wave of wave number xi that comes back in waves of
/// any wave number.
double reflected_energy(const HalfSpace& half_space, double xi);

/// At the middles of 64 equal parts of low .. high, 0 < low < high <= pi.
std::vector<double> reflected_energies(const HalfSpace& half_space, double low, double high);

/// Their mean.
double mean_reflected_energy(const HalfSpace& half_space, double low, double high);

/// The part of its energy that a wave of so many dX loses in a damped lattice on its way over one
/// wavelength; 0 undamped.
double loss_per_wavelength(const HalfSpace& half_space, double wavelength);

}  // namespace nmbcgen
