// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/stability/modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;

/// A Newton step or three on sum_i a_i x^i, as long as they help.
Complex polished(const std::vector<double>& a, Complex x) {
    const auto residual = [&a](Complex at, Complex& slope) {
        Complex value = 0;
        slope = 0;
        for (std::size_t i = a.size(); i-- > 0;) {
            slope = slope * at + value;
            value = value * at + a[i];
        }
        return value;
    };
    Complex slope;
    Complex value = residual(x, slope);
    for (int i = 0; i < 3 && slope != 0.0; ++i) {
        const Complex next = x - value / slope;
        Complex next_slope;
        const Complex next_value = residual(next, next_slope);
        if (std::abs(next_value) >= std::abs(value)) {
            break;
        }
        x = next;
        value = next_value;
        slope = next_slope;
    }
    return x;
}

/// Scales rows and columns by powers of two until they are about equally large (Parlett and
/// Reinsch): where roots differ by orders of magnitude, as next to a G where the stencil is
/// shorter, the small ones would else drown in the roundings of the large ones.
void balance(Eigen::MatrixXd& matrix) {
    constexpr double worth_it = 0.95;
    for (bool changed = true; changed;) {
        changed = false;
        for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
            const double diagonal = std::abs(matrix(i, i));
            const double row = matrix.row(i).lpNorm<1>() - diagonal;
            const double column = matrix.col(i).lpNorm<1>() - diagonal;
            if (row <= 0 || column <= 0) {
                continue;
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

}  // namespace

std::vector<Complex> polynomial_roots(const std::vector<double>& coefficients) {
    const auto degree = Eigen::Index(coefficients.size()) - 1;
    if (degree < 1) {
        return {};
    }
    Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(degree, degree);
    for (Eigen::Index i = 0; i < degree; ++i) {
        companion(i, degree - 1) = -coefficients[std::size_t(i)] / coefficients.back();
        if (i > 0) {
            companion(i, i - 1) = 1;
        }
    }
    balance(companion);
    const Eigen::VectorXcd values = companion.eigenvalues();
    std::vector<Complex> roots(values.begin(), values.end());
    for (Complex& root : roots) {
        root = polished(coefficients, root);
    }
    return roots;
}

std::vector<Mode> outgoing_modes(const HalfSpace& half_space, double omega) {
    std::vector<double> polynomial = omega_squared_in_cosine(half_space);
    polynomial[0] -= omega * omega;
    std::vector<Mode> modes;
    for (const Complex x : polynomial_roots(polynomial)) {
        // A polished real root keeps no imaginary part but roundings; where two roots are about
        // to meet, at a band edge, they are lost among them closer than 1e-5.
        constexpr double real_enough = 1e-10;
        if (std::abs(x.imag()) < real_enough && std::abs(x.real()) < 1) {
            const double xi = std::acos(x.real());
            // exp(i(omega t + xi j)) has the group velocity -d omega/d xi along j.
            const double velocity = -omega_squared_slope(half_space, xi) / (2 * omega);
            modes.push_back({std::polar(1.0, velocity > 0 ? xi : -xi), std::abs(velocity)});
        } else {
            // 1/k is the larger one of the two: next to a G where the stencil is shorter x is so
            // large that the difference would be 0.
            const Complex root = std::sqrt(x * x - 1.0);
            const bool same_side = std::abs(x + root) > 1;
            modes.push_back({1.0 / (same_side ? x + root : x - root), 0});
        }
    }
    std::ranges::sort(modes, [](const Mode& left, const Mode& right) {
        const auto key = [](const Mode& mode) {
            return std::tuple(!mode.travels(), std::abs(std::arg(mode.k)), std::abs(mode.k),
                              std::arg(mode.k));
        };
        return key(left) < key(right);
    });
    return modes;
}

const std::vector<Mode>& KnownModes::at(double omega) {
    const auto [entry, is_new] = known_.try_emplace(omega);
    if (is_new) {
        entry->second = outgoing_modes(half_space_, omega);
    }
    return entry->second;
}

}  // namespace nmbcgen
