// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/stability/reflection.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;

Complex residual(const HalfSpace& half_space, double omega, Complex k) {
    return Complex(0, omega) * evaluate_C(half_space, k) - evaluate_B(half_space, k);
}

/// sigma_max(e^D R e^-D), a convex function of the diagonal of D, and a subgradient of it.
struct ScaledNorm {
    double value;
    Eigen::VectorXd subgradient;
};

ScaledNorm scaled_norm(const Eigen::MatrixXcd& R, const Eigen::VectorXd& D) {
    const Eigen::VectorXd scale = D.array().exp();
    const Eigen::MatrixXcd scaled = scale.asDiagonal() * R * scale.cwiseInverse().asDiagonal();
    // Through M^H M: of the largest singular value no digits are lost, and unlike Jacobi's
    // iteration it does not fail on entries of very different size.
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> right(scaled.adjoint() * scaled);
    const double value = std::sqrt(right.eigenvalues()(R.rows() - 1));
    const Eigen::VectorXcd v = right.eigenvectors().col(R.rows() - 1);
    const Eigen::VectorXcd u = scaled * v / value;
    return {value, value * (u.cwiseAbs2() - v.cwiseAbs2())};
}

/// Osborne's balancing: the D that makes each row of e^D R e^-D as large as its column, off the
/// diagonal. Near a band edge amplitudes differ by 1/omega^3 and more, and the ellipsoid method
/// wants to start near its goal.
Eigen::VectorXd balanced(const Eigen::MatrixXcd& R) {
    Eigen::VectorXd D = Eigen::VectorXd::Zero(R.rows());
    for (int sweep = 0; sweep < 20; ++sweep) {
        for (Eigen::Index i = 0; i < R.rows(); ++i) {
            const Eigen::VectorXd scale = D.array().exp();
            const Eigen::VectorXd row = R.row(i).cwiseAbs().transpose().cwiseQuotient(scale);
            const Eigen::VectorXd column = R.col(i).cwiseAbs().cwiseProduct(scale);
            const double row_size = row.squaredNorm() - row(i) * row(i);
            const double column_size = column.squaredNorm() - column(i) * column(i);
            if (row_size > 0 && column_size > 0) {
                D(i) = std::log(column_size / row_size) / 4;
            }
        }
    }
    return D.array() - D(R.rows() - 1);
}

}  // namespace

Reflection reflection(const HalfSpace& half_space, double omega) {
    Reflection result;
    result.outgoing = outgoing_modes(half_space, omega);
    const auto& out = result.outgoing;
    const auto travelling =
        Eigen::Index(std::ranges::count_if(out, [](const Mode& mode) { return mode.travels(); }));
    const auto all = Eigen::Index(out.size());
    result.amplitudes = Eigen::MatrixXcd(all, travelling);
    result.matrix = Eigen::MatrixXcd(travelling, travelling);
    for (Eigen::Index i = 0; i < travelling; ++i) {
        const Complex incident = 1.0 / out[std::size_t(i)].k;
        for (Eigen::Index o = 0; o < all; ++o) {
            const Complex k = out[std::size_t(o)].k;
            Complex amplitude =
                -residual(half_space, omega, incident) / residual(half_space, omega, k);
            for (Eigen::Index l = 0; l < all; ++l) {
                if (l != o) {
                    const Complex other = 1.0 / out[std::size_t(l)].k;
                    amplitude *= (1.0 / incident - other) / (1.0 / k - other);
                }
            }
            result.amplitudes(o, i) = amplitude;
            if (o < travelling) {
                result.matrix(o, i) = amplitude * std::sqrt(out[std::size_t(o)].group_velocity /
                                                            out[std::size_t(i)].group_velocity);
            }
        }
    }
    return result;
}

Complex scalar_reflection(const HalfSpace& half_space, double xi) {
    const double omega = std::sqrt(omega_squared(half_space, xi));
    return -residual(half_space, omega, std::polar(1.0, xi)) /
           residual(half_space, omega, std::polar(1.0, -xi));
}

double phase_supremum(const Eigen::MatrixXcd& matrix) {
    // The ellipsoid method on D, whose common factor does not matter, so with a last entry of 0:
    // it shrinks the volume in which a minimum can lie by a fixed factor a step, smooth or not.
    const Eigen::Index free = matrix.rows() - 1;
    const auto norm_at = [&](const Eigen::VectorXd& D) {
        Eigen::VectorXd all = Eigen::VectorXd::Zero(free + 1);
        all.head(free) = D;
        ScaledNorm norm = scaled_norm(matrix, all);
        norm.subgradient.conservativeResize(free);
        return norm;
    };
    Eigen::VectorXd centre = balanced(matrix).head(free);
    ScaledNorm norm = norm_at(centre);
    double best = norm.value;
    constexpr double radius = 10;  // in D, about the balanced one
    Eigen::MatrixXd shape = radius * radius * Eigen::MatrixXd::Identity(free, free);
    const auto d = double(free);
    constexpr double precision = 1e-10;
    constexpr double not_above_one = 1 + precision;
    for (int step = 0; step < 2000 && free > 0 && best > not_above_one; ++step) {
        const Eigen::VectorXd direction = shape * norm.subgradient;
        const double width = std::sqrt(norm.subgradient.dot(direction));
        if (!(width > precision)) {
            break;  // the minimum is not below norm.value - width
        }
        if (free == 1) {  // an interval: the method's limit in one dimension
            centre -= direction / (2 * width);
            shape /= 4;
        } else {
            centre -= direction / ((d + 1) * width);
            shape -= 2 / (d + 1) * direction * direction.transpose() / (width * width);
            // A little larger than the formula, so that roundings leave it positive definite.
            shape = (1 + 1e-6) * d * d / (d * d - 1) * (shape + shape.transpose()).eval() / 2;
        }
        norm = norm_at(centre);
        best = std::min(best, norm.value);
    }
    return best;
}

}  // namespace nmbcgen
