// SPDX-License-Identifier: MIT
#include "generator/stability/reflection.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/dense/decompositions.hpp"

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;

/// Delta(k) = sigma C(k) - B(k)
Complex residual(CAndB at_k, Complex sigma) {
    return sigma * at_k.C - at_k.B;
}

}  // namespace

ReflectionInSteps::ReflectionInSteps(const HalfSpace& half_space, std::vector<Mode> outgoing) {
    const std::size_t all = outgoing.size();
    const auto travelling = half_space.is_damped()
                                ? all
                                : std::size_t(std::ranges::count_if(
                                      outgoing, [](const Mode& mode) { return mode.travels(); }));
    std::vector<Complex> inverse;  // 1/k_l
    inverse.reserve(all);
    for (const Mode& mode : outgoing) {
        inverse.push_back(1.0 / mode.k);
        sent_.push_back(evaluate_condition(half_space, mode.k));
    }
    std::vector<Complex> apart;  // prod_{l != o} (1/k_o - 1/k_l)
    for (std::size_t o = 0; o < all; ++o) {
        Complex product = 1;
        for (std::size_t l = 0; l < all; ++l) {
            product *= l == o ? 1.0 : inverse[o] - inverse[l];
        }
        apart.push_back(product);
    }
    std::vector<Complex> from_images;  // prod_l (k_i - 1/k_l)
    // d(omega^2)/d xi but for a factor of all, since omega^2(k) - omega^2 has the zeros k_l and
    // 1/k_l: of the same differences as the amplitudes. Where two waves meet, their roundings, of
    // which those differences consist, so leave no trace in sigma_max.
    std::vector<double> fluxes;
    for (std::size_t i = 0; i < travelling; ++i) {
        Complex product = 1;
        for (const Complex other : inverse) {
            product *= outgoing[i].k - other;
        }
        from_images.push_back(product);
        fluxes.push_back(half_space.is_damped() ? 1 : std::abs(apart[i] * product));
        incident_.push_back(evaluate_condition(half_space, inverse[i]));
    }
    cauchy_.resize(Eigen::Index(all), Eigen::Index(travelling));
    flux_ratios_.resize(Eigen::Index(travelling), Eigen::Index(travelling));
    for (std::size_t i = 0; i < travelling; ++i) {
        const auto column = Eigen::Index(i);
        for (std::size_t o = 0; o < all; ++o) {
            cauchy_(Eigen::Index(o), column) =
                -from_images[i] / ((outgoing[i].k - inverse[o]) * apart[o]);
        }
        for (std::size_t o = 0; o < travelling; ++o) {
            flux_ratios_(Eigen::Index(o), column) = std::sqrt(fluxes[o] / fluxes[i]);
        }
    }
    reflection_.outgoing = std::move(outgoing);
}

const Reflection& ReflectionInSteps::at(Complex sigma) {
    reflection_.amplitudes = cauchy_;
    for (Eigen::Index o = 0; o < cauchy_.rows(); ++o) {
        reflection_.amplitudes.row(o) /= residual(sent_[std::size_t(o)], sigma);
    }
    for (Eigen::Index i = 0; i < cauchy_.cols(); ++i) {
        reflection_.amplitudes.col(i) *= residual(incident_[std::size_t(i)], sigma);
    }
    reflection_.matrix = reflection_.amplitudes.topRows(cauchy_.cols()).cwiseProduct(flux_ratios_);
    return reflection_;
}

Reflection reflection(const HalfSpace& half_space, double omega) {
    return reflection(half_space, omega, outgoing_modes(half_space, omega));
}

Reflection reflection(const HalfSpace& half_space, double omega, std::vector<Mode> outgoing) {
    return ReflectionInSteps(half_space, std::move(outgoing)).at(boundary_rate(half_space, omega));
}

Complex scalar_reflection(const HalfSpace& half_space, double xi) {
    const double omega = std::sqrt(omega_squared(half_space, xi));
    const Complex sigma = boundary_rate(half_space, omega);
    const auto residual_at = [&](double wave_number) {
        return residual(evaluate_condition(half_space, std::polar(1.0, wave_number)), sigma);
    };
    return -residual_at(xi) / residual_at(-xi);
}

double round_trip_supremum(const Reflection& one, const Reflection& other) {
    const Eigen::Index waves = one.matrix.rows();
    Eigen::VectorXd angles(waves);
    for (Eigen::Index wave = 0; wave < waves; ++wave) {
        angles(wave) = std::arg(one.outgoing[std::size_t(wave)].k);
    }
    Eigen::MatrixXd X(waves, waves);
    for (Eigen::Index o = 0; o < waves; ++o) {
        for (Eigen::Index i = 0; i < waves; ++i) {
            const double half_sum = (angles(o) + angles(i)) / 2;
            // eta_o + eta_i is sin(half_sum) over two cosines, which are positive.
            const double size =
                std::sqrt(std::abs(one.matrix(o, i)) * std::abs(other.matrix(i, o)));
            X(o, i) = std::copysign(size, std::sin(half_sum));
        }
    }
    return squared_spectral_norm(X);
}

double damped_round_trip_supremum(const Reflection& one, const Reflection& other, std::size_t nodes,
                                  double coarse) {
    const Eigen::Index waves = one.matrix.rows();
    const auto k = [&one](Eigen::Index wave) { return one.outgoing[std::size_t(wave)].k; };
    // By abs2: abs would care for what overflows, and take most of the time.
    const Eigen::MatrixXd sizes = one.matrix.cwiseAbs2().cwiseSqrt();
    const Eigen::MatrixXd other_sizes = other.matrix.cwiseAbs2().cwiseSqrt();
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
            const double squared =
                sizes(o, i) * other_sizes(i, o) * faded(o) * faded(i) / std::norm(sum);
            X(o, i) = std::sqrt(squared) * std::conj(sum);
        }
    }
    const double bound = X.squaredNorm();
    return bound <= coarse ? bound : squared_spectral_norm(X);
}

}  // namespace nmbcgen
