// SPDX-License-Identifier: MIT
/// The fully discrete chain: leapfrog between two ends, as the runtime steps it.
#pragma once

#include <Eigen/Core>

#include "generator/stability/lattice_end.hpp"
#include "generator/stability/step_grades.hpp"

namespace nmbcgen {

/// The map of one time step on u and v, each on all nodes, u at level k, v at k-1/2, which damping
/// reads on the ghosts, too, with midpoint ghosts. nodes: interior ones; time_step in dX/c.
/// The ends are of one lattice. Ghosts of a fixed or free end are as the end has them, whatever the
/// state says.
/// Throws std::invalid_argument where the chain is shorter than an end reaches.
Eigen::MatrixXd one_step_map(const LatticeEnd& left, const LatticeEnd& right, std::size_t nodes,
                             double time_step);

/// All eigenvalues of such a map or of another matrix that mirrors the chain onto itself: on u on
/// `all` nodes, then v on as many or on the interior ones, each in the order of the nodes. Even
/// states and odd ones apart: that takes a quarter of the time, and where modes come in even and
/// odd pairs it keeps roundings from splitting them.
Eigen::VectorXcd eigenvalues_by_parity(const Eigen::MatrixXd& matrix, Eigen::Index all);

/// The spectral radius of the one-step map between two such ends.
double spectral_radius(const LatticeEnd& both, std::size_t nodes, double time_step);

/// The spectral radius of the one-step map.
double spectral_radius(const LatticeEnd& left, const LatticeEnd& right, std::size_t nodes,
                       double time_step);

/// The top of the band, omega_max [c/dX].
double maximum_frequency(const HalfSpace& half_space);

/// cfl = dt omega_max / 2 of steps [dX/c], omega_max that of the undamped band.
double cfl_of(const HalfSpace& half_space, double time_step);

/// Steps by their cfl = dt omega_max / 2, omega_max that of the undamped band.
struct StepRange {
    double from = 0;
    double largest = 0;  ///< 0: there are none

    bool contains(double cfl) const { return from <= cfl && cfl <= largest; }
};

/// On an edge a mode neither grows nor dies: a step is stable where one longer by this factor is.
inline constexpr double off_the_edge = 1 + 1e-6;

/// The steps that have at least this grade, by the half-space condition in time steps
/// (half_space.hpp), which holds for every length but short ones.
///     largest  in steps of 0.01, with every 0.05 below it
///     from     above all shorter ones, down to 1e-5, in which a boundary mode grows, rounded up to
///              0.001; 0 where none does
/// A condition near a pole in G has a zero k of C close to 0, where omega^2(k) is so large that its
/// mode is stiff: it decays in continuous time, and grows in all but the shortest and longer steps.
StepRange stable_range(StepGrades& grades, Grade least);
StepRange stable_range(const HalfSpace& half_space, Grade least = Grade::paired);

}  // namespace nmbcgen
