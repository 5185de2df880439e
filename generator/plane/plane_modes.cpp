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

/// Where the farthest forces lack a component, or are all in one direction, as if they had a tiny
/// spring in addition: modes of z next to 0 and infinity, which carry nothing, in place of 0 and
/// infinity. Long waves have the same energy with it but for xi^2 times as much.
LateralChain without_gaps(LateralChain chain) {
    constexpr double tiny = 1e-8;
    constexpr double none = 1e-14;  // roundings
    MatrixXd& farthest = chain.stiffness.back();
    const auto add_spring = [&](Index a) {
        MatrixXd& middle = chain.stiffness[chain.reach()];
        const double stiffness = tiny * middle(a, a);
        chain.stiffness.front()(a, a) -= stiffness;
        farthest(a, a) -= stiffness;
        middle(a, a) += 2 * stiffness;
    };
    const Eigen::VectorXd rows = farthest.rowwise().norm();
    bool lacks_one = false;
    for (Index a = 0; a < chain.components(); ++a) {
        if (rows(a) < none * chain.stiffness[chain.reach()](a, a)) {
            add_spring(a);
            lacks_one = true;
        }
    }
    // Of [[p, q], [-q, r]] with p r = -q^2, the determinant is then the other diagonal entry times
    // the spring's stiffness.
    constexpr double singular = 1e-10;
    if (!lacks_one && chain.components() == 2 &&
        std::abs(farthest(0, 0) * farthest(1, 1) - farthest(0, 1) * farthest(1, 0)) <
            singular * rows.squaredNorm()) {
        add_spring(std::abs(farthest(0, 0)) < std::abs(farthest(1, 1)) ? 0 : 1);
    }
    return chain;
}

/// The layers I-reach .. I+reach-1 to the next ones, of motions exp(s t): u_{I+reach} from
/// s^2 u_I = - sum_r stiffness[reach + r] u_{I+r}.
template <class Matrix>
Matrix transfer(const std::vector<Matrix>& stiffness, typename Matrix::Scalar square_of_s) {
    const auto reach = Index(stiffness.size() - 1) / 2;
    const Index size = stiffness.front().rows();
    const Index last = (2 * reach - 1) * size;
    const Matrix outermost = inverse_of(stiffness.back());
    Matrix step = Matrix::Zero(last + size, last + size);
    step.topRightCorner(last, last).setIdentity();
    for (Index r = 0; r < 2 * reach; ++r) {
        step.block(last, size * r, size, size) = -outermost * stiffness[std::size_t(r)];
    }
    step.block(last, size * reach, size, size) -= square_of_s * outermost;
    return step;
}

/// Of an eigenvector of transfer(): of a growing solution the last layer, of a decaying one the
/// first has the digits.
Eigen::VectorXcd shape_of(const Eigen::VectorXcd& layers, Complex z, Index size) {
    return (std::abs(z) < 1 ? layers.head(size) : layers.tail(size)).normalized();
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
    const Eigenpairs pairs = eigenpairs(transfer(without_gaps(chain).stiffness, -omega * omega));
    std::vector<PlaneMode> travelling;
    std::vector<PlaneMode> decaying;
    for (Index i = 0; i < pairs.values.size(); ++i) {
        const Complex z = pairs.values(i);
        const double modulus = std::abs(z);
        const Eigen::VectorXcd shape = shape_of(pairs.vectors.col(i), z, size);
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

std::vector<PlaneMode> decaying_plane_modes(const LateralChain& chain, Complex s) {
    const LateralChain whole = without_gaps(chain);
    std::vector<Eigen::MatrixXcd> stiffness;
    for (std::size_t r = 0; r < whole.stiffness.size(); ++r) {
        stiffness.emplace_back(whole.stiffness[r].cast<Complex>() + s * whole.damping[r]);
    }
    const Eigenpairs pairs = eigenpairs(transfer(stiffness, s * s));
    std::vector<PlaneMode> modes;
    for (Index i = 0; i < pairs.values.size(); ++i) {
        const Complex z = pairs.values(i);
        modes.push_back({.z = z, .shape = shape_of(pairs.vectors.col(i), z, chain.components())});
    }
    std::ranges::sort(modes, {}, [](const PlaneMode& mode) { return std::abs(mode.z); });
    modes.resize(modes.size() / 2);
    return modes;
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
