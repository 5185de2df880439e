// SPDX-License-Identifier: MIT
#include "generator/dense/decompositions.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <complex>

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
    if (X.size() == 0) {
        return 0;
    }
    const Matrix square = X.adjoint() * X;
    if (square.cols() == 1) {
        return std::real(square(0, 0));
    }
    if (square.cols() == 2) {
        const double mean = std::real(square(0, 0) + square(1, 1)) / 2;
        const double half_difference = std::real(square(0, 0) - square(1, 1)) / 2;
        return mean + std::hypot(half_difference, std::abs(square(1, 0)));
    }
    return ascending_eigenvalues(square)(square.cols() - 1);
}

}  // namespace

VectorXcd eigenvalues(const MatrixXd& matrix) {
    return matrix.eigenvalues();
}

VectorXcd eigenvalues(const MatrixXcd& matrix) {
    return matrix.eigenvalues();
}

VectorXcd eigenvalues_of_hessenberg(const MatrixXd& matrix) {
    const double scale = matrix.cwiseAbs().maxCoeff();
    if (scale == 0) {
        return VectorXcd::Zero(matrix.rows());
    }
    Eigen::RealSchur<MatrixXd> schur(matrix.rows());
    schur.computeFromHessenberg(matrix / scale, MatrixXd(), false);
    const MatrixXd& T = schur.matrixT();  // with blocks of two rows for complex pairs
    VectorXcd values(T.rows());
    for (Eigen::Index i = 0; i < T.rows(); ++i) {
        if (i + 1 == T.rows() || T(i + 1, i) == 0) {
            values(i) = T(i, i);
            continue;
        }
        const double half = (T(i, i) - T(i + 1, i + 1)) / 2;
        const double imaginary = std::sqrt(std::abs(half * half + T(i + 1, i) * T(i, i + 1)));
        const std::complex<double> value(T(i + 1, i + 1) + half, imaginary);
        values(i) = value;
        values(++i) = std::conj(value);
    }
    return scale * values;
}

Eigenpairs eigenpairs(const MatrixXd& matrix) {
    const Eigen::EigenSolver<MatrixXd> solver(matrix);
    return {.values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
}

Eigenpairs eigenpairs(const MatrixXcd& matrix) {
    const Eigen::ComplexEigenSolver<MatrixXcd> solver(matrix);
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

MatrixXcd inverse_of(const MatrixXcd& matrix) {
    return matrix.inverse();
}

MatrixXcd solution_of(const MatrixXcd& matrix, const MatrixXcd& right_sides) {
    return matrix.partialPivLu().solve(right_sides);
}

std::complex<double> determinant_of(const MatrixXcd& matrix) {
    return matrix.partialPivLu().determinant();
}

}  // namespace nmbcgen
