// SPDX-License-Identifier: MIT
/// Finite elements of a bar that is local here and nonlocal there: from exact integrals to
/// matrices.
#pragma once

#include <Eigen/SparseCore>
#include <map>
#include <vector>

#include "generator/coupling/mesh.hpp"
#include "generator/coupling/pair_matrix.hpp"

namespace nmbcgen {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// K [force/length] of all nodes, every integral exact until it is rounded; the bar is free where
/// the mesh ends. In the form of rows a local element has half of the kink, k/2 (u'_left -
/// u'_right), at either of its nodes.
SparseMatrix stiffness_of(const Mesh& mesh, CouplingForm form);

/// A row of it, exact, by column; no entry is 0.
using ExactRow = std::map<std::size_t, LogNumber>;

/// Of the nodes first .. last.
std::vector<ExactRow> exact_rows(const Mesh& mesh, CouplingForm form, std::size_t first,
                                 std::size_t last);

/// Half of the elements beside each node [length]: the masses at density 1, all on the diagonal.
Eigen::VectorXd masses_of(const Mesh& mesh);

inline constexpr unsigned largest_coupling_horizon = 100;

/// A row of K in units of k/h, from the diagonal outwards, of a uniform bar whose horizon is so
/// many element lengths h, at most largest_coupling_horizon. Both forms have the same.
std::vector<LogNumber> uniform_stencil(const Rational& horizon);

}  // namespace nmbcgen
