// SPDX-License-Identifier: MIT
#include "generator/dense/decompositions.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace nmbcgen {
namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

template <class Matrix>
VectorXd ascending_eigenvalues(const Matrix& matrix) {
    return Eigen::SelfAdjointEigenSolver<Matrix>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
}

template <class Matrix>
double largest_of_square(const Matrix& X) {
    return X.size() == 0 ? 0 : ascending_eigenvalues(Matrix(X.adjoint() * X))(X.cols() - 1);
}

}  // namespace

VectorXcd eigenvalues(const MatrixXd& matrix) {
    return matrix.eigenvalues();
}

VectorXcd eigenvalues(const MatrixXcd& matrix) {
    return matrix.eigenvalues();
}

Eigenpairs eigenpairs(const MatrixXd& matrix) {
    const Eigen::EigenSolver<MatrixXd> solver(matrix);
    return {.values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
}

SymmetricEigenpairs symmetric_eigenpairs(const MatrixXd& matrix) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(matrix);
    return {.values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
}

VectorXd symmetric_eigenvalues(const MatrixXd& matrix) {
    return ascending_eigenvalues(matrix);
}

double squared_spectral_norm(const MatrixXd& X) {
    return largest_of_square(X);
}

double squared_spectral_norm(const MatrixXcd& X) {
    return largest_of_square(X);
}

MatrixXd inverse_of(const MatrixXd& matrix) {
    return matrix.inverse();
}

MatrixXcd solution_of(const MatrixXcd& matrix, const MatrixXcd& right_sides) {
    return matrix.partialPivLu().solve(right_sides);
}

}  // namespace nmbcgen
