// SPDX-License-Identifier: MIT
/// Least squares, linear and not, by Eigen.
#ifndef NMBCGEN_DENSE_LEAST_SQUARES_HPP
#define NMBCGEN_DENSE_LEAST_SQUARES_HPP

#include <Eigen/Core>
#include <functional>

namespace nmbcgen {

/// Of all x that leave the least |matrix x - right_side|, the shortest. Pivots below such a part of
/// the largest count as 0.
Eigen::VectorXd least_norm_solution(const Eigen::MatrixXd& matrix,
                                    const Eigen::VectorXd& right_side, double threshold);

/// Residuals and their derivatives: a row for each residual, a column for each parameter.
struct Linearised {
    Eigen::VectorXd values;
    Eigen::MatrixXd slopes;
};

/// Parameters near `start` whose residuals have a least sum of squares (Levenberg and Marquardt),
/// nine digits or so of them, or what is found after so many evaluations.
/// @throws std::domain_error if the search leaves the finite numbers
Eigen::VectorXd least_squares(const Eigen::VectorXd& start,
                              const std::function<Linearised(const Eigen::VectorXd&)>& residuals,
                              Eigen::Index evaluations);

}  // namespace nmbcgen

#endif
