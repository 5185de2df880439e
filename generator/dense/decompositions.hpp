// SPDX-License-Identifier: MIT
/// Eigenvalues and solutions of dense matrices of doubles, by Eigen. Eigen's decompositions are
/// compiled here alone: they take longer to compile than all else in a file that uses them.
#ifndef NMBCGEN_DENSE_DECOMPOSITIONS_HPP
#define NMBCGEN_DENSE_DECOMPOSITIONS_HPP

#include <Eigen/Core>
#include <complex>

namespace nmbcgen {

/// Of a square matrix, in no order.
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix);
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXcd& matrix);

/// Likewise, of one that is 0 below its first subdiagonal; quicker.
Eigen::VectorXcd eigenvalues_of_hessenberg(const Eigen::MatrixXd& matrix);

struct Eigenpairs {
    Eigen::VectorXcd values;
    Eigen::MatrixXcd vectors;  ///< columns, in the order of the values
};

Eigenpairs eigenpairs(const Eigen::MatrixXd& matrix);
Eigenpairs eigenpairs(const Eigen::MatrixXcd& matrix);

struct SymmetricEigenpairs {
    Eigen::VectorXd values;   ///< ascending
    Eigen::MatrixXd vectors;  ///< columns, orthonormal
};

/// Of the lower triangle.
SymmetricEigenpairs symmetric_eigenpairs(const Eigen::MatrixXd& matrix);
/// Ascending; of the lower triangle.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix);

/// The largest eigenvalue of X^H X; 0 of an empty matrix.
double squared_spectral_norm(const Eigen::MatrixXd& X);
double squared_spectral_norm(const Eigen::MatrixXcd& X);

/// Of a regular matrix.
Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& matrix);
Eigen::MatrixXcd inverse_of(const Eigen::MatrixXcd& matrix);
Eigen::MatrixXcd solution_of(const Eigen::MatrixXcd& matrix, const Eigen::MatrixXcd& right_sides);
std::complex<double> determinant_of(const Eigen::MatrixXcd& matrix);

}  // namespace nmbcgen

#endif
