// SPDX-License-Identifier: GPL-2.0-or-later
/// What the modal analysis says will be left of a pulse: each of its waves on its own, by energy.
#pragma once

#include <vector>

#include "generator/stability/half_space.hpp"

namespace stability_atlas {

/// A chain between two like ends, and how long it runs.
struct Course {
    double length = 0;    ///< [dX]
    double duration = 0;  ///< [dX/c]
};

/// What is left of the energy of a wave that starts in the middle of the chain, in the time steps
/// of the half space.
///
/// A wave travels at its group velocity; at an end, its energy is divided among the outgoing waves
/// of its frequency as reflected_wave() says; and so on until the time is over. Damping takes its
/// rate on the way. Energies are added, not amplitudes: waves that have come different ways and
/// overlap may have more or less.
struct Ray {
    double xi;             ///< [1/dX], in (0, pi)
    double left;           ///< of 1
    double not_yet_there;  ///< the part of it that has not met an end
};

/// Of so many wave numbers, evenly through (0, pi), at the midpoints.
std::vector<Ray> trace(const nmbcgen::HalfSpace& half_space, const Course& course, int samples);

/// Parts of a pulse's energy at the start.
struct Prediction {
    double left = 0;
    double not_yet_there = 0;
};

/// Of the pulse u = exp(-(x/w)^2), v = 0, w the half-width [dX], energies as
/// nmbc::Energies::total() has them.
Prediction predict(const nmbcgen::HalfSpace& half_space, const std::vector<Ray>& rays,
                   double half_width);

}  // namespace stability_atlas
