// SPDX-License-Identifier: MIT
#include "generator/plane/plane_modes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "generator/dense/decompositions.hpp"
#include "generator/dense/portable_math.hpp"

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;

constexpr double resolved = 1e-6;  // what doubles resolve of a double root, and more

/// Where the farthest forces lack a component, as if it had a tiny spring there: modes of z next to
/// 0 and infinity, which carry nothing, in place of 0 and infinity. Long waves have the same energy
/// with it but for xi^2 times as much.
LateralChain without_gaps(LateralChain chain) {
    constexpr double tiny = 1e-8;
    constexpr double none = 1e-14;  // roundings
    Eigen::MatrixXd& middle = chain.stiffness[chain.reach()];
    for (Index a = 0; a < chain.components(); ++a) {
        const double scale = middle(a, a);
        if (chain.stiffness.back().row(a).norm() < none * scale) {
            chain.stiffness.front()(a, a) -= tiny * scale;
            chain.stiffness.back()(a, a) -= tiny * scale;
            middle(a, a) += 2 * tiny * scale;
        }
    }
    return chain;
}

/// The layers I-reach .. I+reach-1 to the next ones: u_{I+reach} from the equation of motion.
MatrixXd transfer(const LateralChain& chain, double omega) {
    const auto reach = Index(chain.reach());
    const Index size = chain.components();
    const Index last = (2 * reach - 1) * size;
    const MatrixXd outermost = inverse_of(chain.stiffness.back());
    MatrixXd step = MatrixXd::Zero(last + size, last + size);
    step.topRightCorner(last, last).setIdentity();
    for (Index r = 0; r < 2 * reach; ++r) {
        step.block(last, size * r, size, size) = -outermost * chain.stiffness[std::size_t(r)];
    }
    step.block(last, size * reach, size, size) += omega * omega * outermost;
    return step;
}

/// Of U z^I exp(i omega t), z = exp(i xi): -d(omega)/d(xi), half the derivative of U.K(z)U over
/// omega.
double group_velocity(const LateralChain& chain, double omega, Complex z,
                      const Eigen::VectorXcd& shape) {
    Complex sum = 0;
    const auto reach = int(chain.reach());
    for (int r = -reach; r <= reach; ++r) {
        sum += Complex(0, r) * portable::power(z, r) *
               shape.dot(chain.stiffness[std::size_t(r + reach)] * shape);
    }
    return -sum.real() / (2 * omega);
}

/// Of the travelling wave exp(+-i xi I).
Index column_of(const std::vector<PlaneMode>& outgoing, double xi) {
    const Complex own = portable::unit(xi);
    const auto distance = [&](const PlaneMode& mode) {
        return mode.travels() ? std::min(std::abs(mode.z - own), std::abs(mode.z - 1.0 / own)) : 2;
    };
    return std::ranges::min_element(outgoing, {}, distance) - outgoing.begin();
}

}  // namespace

PlaneMode mirror_image(PlaneMode mode) {
    mode.z = 1.0 / mode.z;
    mode.shape(0) *= -1;
    mode.group_velocity *= -1;
    return mode;
}

std::vector<PlaneMode> outgoing_plane_modes(const LateralChain& chain, double omega) {
    const Index size = chain.components();
    const Eigenpairs pairs = eigenpairs(transfer(without_gaps(chain), omega));
    std::vector<PlaneMode> travelling;
    std::vector<PlaneMode> decaying;
    for (Index i = 0; i < pairs.values.size(); ++i) {
        const Complex z = pairs.values(i);
        const double modulus = std::abs(z);
        // Of a growing solution the last layer, of a decaying one the first has the digits.
        const Eigen::VectorXcd layers = pairs.vectors.col(i);
        const Eigen::VectorXcd shape =
            (modulus < 1 ? layers.head(size) : layers.tail(size)).normalized();
        if (modulus < 1 - resolved) {
            decaying.push_back({.z = z, .shape = shape});
        } else if (modulus < 1 + resolved) {
            const Complex unit = z / modulus;
            const double speed = group_velocity(chain, omega, unit, shape);
            const double scale = chain.stiffness[chain.reach()].norm() / omega;
            if (!(std::abs(speed) > resolved * scale)) {
                return {};
            }
            if (speed > 0) {
                travelling.push_back({.z = unit, .shape = shape, .group_velocity = speed});
            }
        }
    }
    if (Index(travelling.size() + decaying.size()) != size * Index(chain.reach())) {
        return {};
    }
    travelling.insert(travelling.end(), decaying.begin(), decaying.end());
    return travelling;
}

Index travelling_count(const std::vector<PlaneMode>& outgoing) {
    return std::ranges::count_if(outgoing, &PlaneMode::travels);
}

Eigen::MatrixXcd in_flux_metric(Eigen::MatrixXcd amplitudes,
                                const std::vector<PlaneMode>& outgoing) {
    for (Index o = 0; o < amplitudes.rows(); ++o) {
        for (Index i = 0; i < amplitudes.cols(); ++i) {
            amplitudes(o, i) *= std::sqrt(outgoing[std::size_t(o)].group_velocity /
                                          outgoing[std::size_t(i)].group_velocity);
        }
    }
    return amplitudes;
}

ArrivingWave arriving_wave(const PlaneLattice& lattice, bool is_P, double xi, double angle) {
    constexpr double aside = 1e-4;
    for (const double turned : {angle, angle - aside, angle + aside}) {
        const Eigen::Vector2d wave_vector(xi * portable::cos(turned), xi * portable::sin(turned));
        const SymmetricEigenpairs waves =
            symmetric_eigenpairs(dynamical_matrix(lattice.bonds, wave_vector).value);
        const Eigen::Vector2d overlap = (waves.vectors.transpose() * wave_vector).cwiseAbs();
        const Index branch = (overlap(1) > overlap(0)) == is_P ? 1 : 0;
        ArrivingWave wave{.omega = std::sqrt(waves.values(branch)),
                          .wave_number = wave_vector.y(),
                          .outgoing = {},
                          .column = 0};
        wave.outgoing = outgoing_plane_modes(lateral_chain(lattice, wave.wave_number), wave.omega);
        if (!wave.outgoing.empty()) {
            wave.column = column_of(wave.outgoing, wave_vector.x());
            return wave;
        }
    }
    throw std::domain_error("the modes at a side cannot be told from each other");
}

double omega_squared(const LateralChain& chain, double xi) {
    double sum = 0;
    const auto reach = int(chain.reach());
    for (int r = -reach; r <= reach; ++r) {
        sum += chain.stiffness[std::size_t(r + reach)](0, 0) * portable::cos(r * xi);
    }
    return sum;
}

ArrivingWave arriving_wave(const LateralChain& chain, double xi) {
    ArrivingWave wave{.omega = std::sqrt(omega_squared(chain, xi)),
                      .wave_number = 0,
                      .outgoing = {},
                      .column = 0};
    wave.outgoing = outgoing_plane_modes(chain, wave.omega);
    if (wave.outgoing.empty()) {
        throw std::domain_error("the modes at an end cannot be told from each other");
    }
    wave.column = column_of(wave.outgoing, xi);
    // Of long waves the eigenvalue loses digits, next to that of the wave in the other direction.
    PlaneMode& mode = wave.outgoing[std::size_t(wave.column)];
    mode.z = portable::unit(std::copysign(xi, mode.z.imag()));
    mode.group_velocity = group_velocity(chain, wave.omega, mode.z, mode.shape);
    return wave;
}

}  // namespace nmbcgen
