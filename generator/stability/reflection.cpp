// SPDX-License-Identifier: MIT
#include "generator/stability/reflection.hpp"

#include <algorithm>
#include <cmath>

#include "generator/dense/decompositions.hpp"

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;

Complex residual(const HalfSpace& half_space, double omega, Complex k) {
    return boundary_rate(half_space, omega) * evaluate_C(half_space, k) - evaluate_B(half_space, k);
}

}  // namespace

Reflection reflection(const HalfSpace& half_space, double omega) {
    return reflection(half_space, omega, outgoing_modes(half_space, omega));
}

Reflection reflection(const HalfSpace& half_space, double omega, const std::vector<Mode>& out) {
    Reflection result;
    result.outgoing = out;
    const auto all = Eigen::Index(out.size());
    const auto travelling = half_space.is_damped()
                                ? all
                                : Eigen::Index(std::ranges::count_if(
                                      out, [](const Mode& mode) { return mode.travels(); }));
    result.amplitudes = Eigen::MatrixXcd(all, travelling);
    result.matrix = Eigen::MatrixXcd(travelling, travelling);
    // Delta(k_o) prod_{l != o} (1/k_o - 1/k_l)
    std::vector<Complex> denominators;
    for (const Mode& mode : out) {
        Complex product = residual(half_space, omega, mode.k);
        for (const Mode& other : out) {
            product *= &other == &mode ? 1.0 : 1.0 / mode.k - 1.0 / other.k;
        }
        denominators.push_back(product);
    }
    for (Eigen::Index i = 0; i < travelling; ++i) {
        const Complex inverse_incident = out[std::size_t(i)].k;
        Complex numerator = -residual(half_space, omega, 1.0 / inverse_incident);
        for (const Mode& other : out) {
            numerator *= inverse_incident - 1.0 / other.k;
        }
        for (Eigen::Index o = 0; o < all; ++o) {
            const Mode& mode = out[std::size_t(o)];
            const Complex amplitude =
                numerator / ((inverse_incident - 1.0 / mode.k) * denominators[std::size_t(o)]);
            result.amplitudes(o, i) = amplitude;
            if (o < travelling) {
                const double flux = half_space.is_damped()
                                        ? 1
                                        : mode.group_velocity / out[std::size_t(i)].group_velocity;
                result.matrix(o, i) = amplitude * std::sqrt(flux);
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

double round_trip_supremum(const Reflection& one, const Reflection& other) {
    const Eigen::Index waves = one.matrix.rows();
    Eigen::MatrixXd X(waves, waves);
    for (Eigen::Index o = 0; o < waves; ++o) {
        for (Eigen::Index i = 0; i < waves; ++i) {
            const double half_sum = (std::arg(one.outgoing[std::size_t(o)].k) +
                                     std::arg(one.outgoing[std::size_t(i)].k)) /
                                    2;
            // eta_o + eta_i is sin(half_sum) over two cosines, which are positive.
            const double size =
                std::sqrt(std::abs(one.matrix(o, i)) * std::abs(other.matrix(i, o)));
            X(o, i) = std::copysign(size, std::sin(half_sum));
        }
    }
    return squared_spectral_norm(X);
}

double damped_round_trip_supremum(const Reflection& one, const Reflection& other,
                                  std::size_t nodes) {
    const Eigen::Index waves = one.matrix.rows();
    const auto k = [&one](Eigen::Index wave) { return one.outgoing[std::size_t(wave)].k; };
    Eigen::VectorXd faded(waves);  // by the way from end to end
    for (Eigen::Index wave = 0; wave < waves; ++wave) {
        faded(wave) = std::pow(std::abs(k(wave)), double(nodes) + 1);
    }
    Eigen::MatrixXcd X(waves, waves);
    for (Eigen::Index o = 0; o < waves; ++o) {
        for (Eigen::Index i = 0; i < waves; ++i) {
            // y_o + y_i is this over (1 + k_o)(1 + k_i)/2, a factor of the row and one of the
            // column
            const Complex sum = k(o) * k(i) - 1.0;
            const double size = std::sqrt(std::abs(one.matrix(o, i)) *
                                          std::abs(other.matrix(i, o)) * faded(o) * faded(i));
            X(o, i) = size * std::conj(sum) / std::abs(sum);
        }
    }
    return squared_spectral_norm(X);
}

}  // namespace nmbcgen
