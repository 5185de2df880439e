// SPDX-License-Identifier: MIT
/// Nonlinear least squares, by Eigen.
#ifndef NMBCGEN_DENSE_LEAST_SQUARES_HPP
#define NMBCGEN_DENSE_LEAST_SQUARES_HPP

#include <Eigen/Core>
#include <functional>

namespace nmbcgen {

/// Parameters near `start` whose residuals have a least sum of squares (Levenberg and Marquardt),
/// nine digits or so of them.
/// @throws std::domain_error if the search leaves the finite numbers
Eigen::VectorXd least_squares(
    const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& residuals,
    const Eigen::VectorXd& start);

}  // namespace nmbcgen

#endif
