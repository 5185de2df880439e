// SPDX-License-Identifier: MIT
/// Bars at rest, and the cases 1 to 4 of Seleson 2011, part IV.
#pragma once

#include <Eigen/Core>

#include "generator/coupling/mesh.hpp"
#include "generator/coupling/pair_matrix.hpp"

namespace nmbcgen {

/// K u = loads on the nodes that are not held. u holds the displacements of those that are.
/// @throws std::domain_error where K is singular on the free nodes
Eigen::VectorXd equilibrium(const Mesh& mesh, CouplingForm form, const std::vector<bool>& is_held,
                            Eigen::VectorXd u, const Eigen::VectorXd& loads);

/// 1/h of cases 1 and 2: the bar has unit length, and beyond it u is held on one horizon more.
inline constexpr unsigned unit_bar_elements = 80;

/// Case 1: u at x = 1/2, where a unit load is, with k = 1 and u = 0 beyond the bar; the local bar
/// has 1/4.
double displacement_at_load(const Rational& horizon);

/// Case 2: k = 1 left of x = 1/2, 2 right of it, u beyond the bar that of the local bar between 0
/// at x = 0 and 1 at x = 1. The largest |u - local| of a node.
double material_interface_error(const Rational& horizon, CouplingForm form);

/// Cases 3 and 4, the patch test: u = x is given beyond patch_elements elements on either side of
/// x = 0, on as many as the horizons reach. The largest |u - x| of a node, exactly 0 where forces
/// of u = x are exactly 0 on all nodes between.
inline constexpr int patch_elements = 10;
double patch_error(const Halves& halves, CouplingForm form);

}  // namespace nmbcgen
