// SPDX-License-Identifier: MIT
#include "generator/stability/reflection.hpp"

#include <algorithm>
#include <cmath>

#include "generator/dense/decompositions.hpp"

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;

/// Delta(k) = sigma C(k) - B(k) at one frequency.
class Residual {
  public:
    Residual(const HalfSpace& half_space, double omega)
        : half_space_(half_space), sigma_(boundary_rate(half_space, omega)) {}

    Complex operator()(Complex k) const {
        const auto [C, B] = evaluate_condition(half_space_, k);
        return sigma_ * C - B;
    }

  private:
    const HalfSpace& half_space_;
    Complex sigma_;
};

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
    const Residual residual(half_space, omega);
    std::vector<Complex> inverse;  // 1/k_l
    inverse.reserve(out.size());
    for (const Mode& mode : out) {
        inverse.push_back(1.0 / mode.k);
    }
    std::vector<Complex> apart;  // prod_{l != o} (1/k_o - 1/k_l)
    for (std::size_t o = 0; o < out.size(); ++o) {
        Complex product = 1;
        for (std::size_t l = 0; l < out.size(); ++l) {
            product *= l == o ? 1.0 : inverse[o] - inverse[l];
        }
        apart.push_back(product);
    }
    std::vector<Complex> from_images;  // prod_l (k_i - 1/k_l)
    for (Eigen::Index i = 0; i < travelling; ++i) {
        Complex product = 1;
        for (const Complex other : inverse) {
            product *= out[std::size_t(i)].k - other;
        }
        from_images.push_back(product);
    }
    // d(omega^2)/d xi but for a factor of all, since omega^2(k) - omega^2 has the zeros k_l and
    // 1/k_l: of the same differences as the amplitudes. Where two waves meet, their roundings, of
    // which those differences consist, so leave no trace in sigma_max.
    const auto flux_of = [&](std::size_t wave) {
        return std::abs(apart[wave] * from_images[wave]);
    };
    for (Eigen::Index i = 0; i < travelling; ++i) {
        const auto incident = std::size_t(i);
        const Complex numerator = -residual(inverse[incident]) * from_images[incident];
        for (std::size_t o = 0; o < out.size(); ++o) {
            const Complex amplitude =
                numerator / ((out[incident].k - inverse[o]) * (residual(out[o].k) * apart[o]));
            const auto row = Eigen::Index(o);
            result.amplitudes(row, i) = amplitude;
            if (row < travelling) {
                const double flux = half_space.is_damped() ? 1 : flux_of(o) / flux_of(incident);
                result.matrix(row, i) = amplitude * std::sqrt(flux);
            }
        }
    }
    return result;
}

Complex scalar_reflection(const HalfSpace& half_space, double xi) {
    const double omega = std::sqrt(omega_squared(half_space, xi));
    const Residual residual(half_space, omega);
    return -residual(std::polar(1.0, xi)) / residual(std::polar(1.0, -xi));
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
