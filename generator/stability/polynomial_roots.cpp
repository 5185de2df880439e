// SPDX-License-Identifier: MIT
#include "generator/stability/polynomial_roots.hpp"

#include <algorithm>
#include <cmath>

#include "generator/dense/decompositions.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/stability/simultaneous_roots.hpp"

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;

/// Scales rows and columns by powers of two until they are about equally large (Parlett and
/// Reinsch): where roots differ by orders of magnitude, as next to a G where the stencil is
/// shorter, the small ones would else drown in the roundings of the large ones.
template <class Matrix>
void balance(Matrix& matrix) {
    constexpr double worth_it = 0.95;
    for (bool changed = true; changed;) {
        changed = false;
        for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
            const double diagonal = std::abs(matrix(i, i));
            const double row = matrix.row(i).template lpNorm<1>() - diagonal;
            const double column = matrix.col(i).template lpNorm<1>() - diagonal;
            if (row <= 0 || column <= 0) {
                continue;
            }
            if (row < 2 * column && column < 2 * row) {
                continue;  // the factor is 1
            }
            const double factor = std::exp2(std::round(std::log2(row / column) / 2));
            if (column * factor + row / factor < worth_it * (column + row)) {
                matrix.col(i) *= factor;
                matrix.row(i) /= factor;
                changed = true;
            }
        }
    }
}

/// Of a companion matrix.
Eigen::VectorXcd eigenvalues_of(const Eigen::MatrixXd& matrix) {
    return eigenvalues_of_hessenberg(matrix);
}

Eigen::VectorXcd eigenvalues_of(const Eigen::MatrixXcd& matrix) {
    return eigenvalues(matrix);
}

template <class Scalar>
std::vector<Complex> roots_of(const std::vector<Scalar>& coefficients) {
    using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    auto degree = Eigen::Index(coefficients.size()) - 1;
    while (degree > 0 && coefficients[std::size_t(degree)] == Scalar(0)) {
        --degree;
    }
    if (degree < 1) {
        return {};
    }
    Matrix companion = Matrix::Zero(degree, degree);
    for (Eigen::Index i = 0; i < degree; ++i) {
        companion(i, degree - 1) =
            -coefficients[std::size_t(i)] / coefficients[std::size_t(degree)];
        if (i > 0) {
            companion(i, i - 1) = 1;
        }
    }
    balance(companion);
    const Eigen::VectorXcd values = eigenvalues_of(companion);
    std::vector<Complex> roots(values.begin(), values.end());
    for (Complex& root : roots) {
        root = polished(coefficients, root);
    }
    return roots;
}

/// An exact polynomial rounded, scaled to a largest coefficient of 1, zeros at w = 0 divided out.
std::vector<double> rounded_without_zeros(const IntegerPolynomial& polynomial) {
    std::size_t first = 0;
    while (first < polynomial.size() && polynomial[first] == 0) {
        ++first;
    }
    Integer largest = 0;
    for (std::size_t i = first; i < polynomial.size(); ++i) {
        largest = std::max(largest, Integer(abs(polynomial[i])));
    }
    std::vector<double> coefficients;
    for (std::size_t i = first; i < polynomial.size(); ++i) {
        coefficients.push_back(nearest_double(polynomial[i], largest));
    }
    return coefficients;
}

}  // namespace

std::vector<Complex> polynomial_roots(const std::vector<double>& coefficients) {
    return roots_of(coefficients);
}

std::vector<Complex> polynomial_roots(const std::vector<Complex>& coefficients) {
    if (!coefficients.empty() && coefficients.front() != 0.0 && coefficients.back() != 0.0) {
        if (const auto roots = simultaneous_roots(coefficients)) {
            return *roots;
        }
    }
    return roots_of(coefficients);
}

std::vector<Complex> polynomial_roots(const std::vector<Complex>& coefficients,
                                      const std::vector<Complex>& guesses) {
    if (guesses.size() + 1 == coefficients.size() && coefficients.front() != 0.0 &&
        coefficients.back() != 0.0) {
        if (const auto roots = simultaneous_roots(coefficients, guesses)) {
            return *roots;
        }
    }
    return polynomial_roots(coefficients);
}

std::vector<double> derivative(const std::vector<double>& coefficients) {
    std::vector<double> slope(coefficients.begin() + 1, coefficients.end());
    for (std::size_t i = 0; i < slope.size(); ++i) {
        slope[i] *= double(i + 1);
    }
    return slope;
}

std::vector<Complex> nonzero_roots(const Polynomial& polynomial) {
    return nonzero_roots(over_integers(polynomial, common_denominator(polynomial)));
}

std::vector<Complex> nonzero_roots(const IntegerPolynomial& polynomial) {
    return roots_of(rounded_without_zeros(polynomial));
}

}  // namespace nmbcgen
