// SPDX-License-Identifier: MIT
/// A lattice of the plane at one G, in doubles, and what of it waves see that go along a side.
/// Units: those of VectorModel (dX = 1, density 1, Young's modulus 1).
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "generator/table/vector_model.hpp"

namespace nmbcgen {

/// u_tt at node I is - sum over bonds of stiffness u_{I + offset} + damping v_{I + offset}.
struct PlaneBond {
    std::array<int, 2> offset{};
    Eigen::Matrix2d stiffness;
    Eigen::Matrix2d damping;
};

struct PlaneLattice {
    std::vector<PlaneBond> bonds;
    double speed_P = 0;  ///< of long waves along an axis
    double speed_S = 0;
};

/// damping is tau [dX sqrt(density/E)]: forces are of the velocities, too, tau times those of the
/// stabilisation at g = G/pi = 1. Throws NoProjection (lattice/projection.hpp) of a model without
/// long waves of one speed.
PlaneLattice plane_lattice(const VectorModel& model, const Rational& g, const Rational& damping);

std::vector<PlaneBond> plane_bonds(const VectorModel& model, const Rational& g,
                                   const Rational& damping);

/// The dynamical matrix at a wave vector, without damping, of a model that inversion leaves as it
/// is, and its derivatives.
struct DynamicalMatrix {
    Eigen::Matrix2d value = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d by_x = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d by_y = Eigen::Matrix2d::Zero();
};

DynamicalMatrix dynamical_matrix(const std::vector<PlaneBond>& bonds,
                                 const Eigen::Vector2d& wave_vector);

/// The largest omega^2, over so many steps of each wave number from 0 to pi.
double highest_eigenvalue(const PlaneLattice& lattice, std::size_t steps);

/// Waves exp(i k_t y) along a side x = const make a chain of layers, whose nodes have two
/// components u_x and i u_y: layer I has u_tt = - sum_r stiffness[reach + r] u_{I+r} - sum_r
/// damping[reach + r] v_{I+r}. All entries are real where y -> -y is a symmetry of the lattice. The
/// layers of a chain in one dimension have one component.
struct LateralChain {
    std::vector<Eigen::MatrixXd> stiffness;
    std::vector<Eigen::MatrixXd> damping;

    std::size_t reach() const { return (stiffness.size() - 1) / 2; }
    Eigen::Index components() const { return stiffness.front().rows(); }
};

LateralChain lateral_chain(const PlaneLattice& lattice, double wave_number);

}  // namespace nmbcgen
