// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen reflect: the true reflection of a boundary condition over the band.
#pragma once

#include <string>

#include "generator/table/table.hpp"

namespace nmbcgen {

/// CSV, one row for each wave number |xi| = pi (i - 1/2)/samples, i = 1 .. samples, of an incident
/// wave and each outgoing mode it makes: omega [c/dX]; incident_xi [1/dX], signed, of
/// exp(i(omega t + xi j)) with j counted inwards; the outgoing k, its amplitude, and the fraction
/// of the incident energy flux it carries away (0 for a mode that decays; band_reflection.hpp says
/// what it is where the lattice is damped). table: made for the fixed G of its specification.
std::string reflection_csv(const Table& table, unsigned samples);

}  // namespace nmbcgen
