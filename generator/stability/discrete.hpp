// SPDX-License-Identifier: MIT
/// The fully discrete chain: leapfrog between two ends, as the runtime steps it.
#pragma once

#include <Eigen/Core>

#include "generator/stability/lattice_end.hpp"
#include "generator/stability/modal.hpp"

namespace nmbcgen {

/// The map of one time step on u and v, each on all nodes, u at level k, v at k-1/2, which damping
/// reads on the ghosts, too. nodes: interior ones; time_step in dX/c.
/// The ends are of one lattice. Ghosts of a fixed or free end are as the end has them, whatever the
/// state says.
/// Throws std::invalid_argument where the chain is shorter than an end reaches.
Eigen::MatrixXd one_step_map(const LatticeEnd& left, const LatticeEnd& right, std::size_t nodes,
                             double time_step, GhostRule level);

/// The spectral radius of the one-step map.
double spectral_radius(const LatticeEnd& left, const LatticeEnd& right, std::size_t nodes,
                       double time_step, GhostRule level);

/// The top of the band, omega_max [c/dX].
double maximum_frequency(const HalfSpace& half_space);

/// cfl = dt omega_max / 2 of steps [dX/c], omega_max that of the undamped band.
double cfl_of(const HalfSpace& half_space, double time_step);

/// The largest cfl = dt omega_max / 2 in steps of 0.01 that has at least this grade, with every
/// 0.05 below it, by the half-space condition in time steps (half_space.hpp), which holds for every
/// length but short ones. omega_max is that of the undamped band. 0 where there is none.
double largest_cfl(const HalfSpace& half_space, GhostRule level, Grade least = Grade::paired);

}  // namespace nmbcgen
