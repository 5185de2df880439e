// SPDX-License-Identifier: MIT
#include "generator/plane/side_reflection.hpp"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

constexpr double resolved = 1e-6;  // what doubles resolve of a double root, and more

/// Where the farthest forces lack a direction, as if they had a tiny one: modes of z next to 0 and
/// infinity, which carry nothing, in place of 0 and infinity.
LateralChain without_gaps(LateralChain chain) {
    constexpr double tiny = 1e-8;
    Eigen::FullPivLU<MatrixXd> farthest(chain.stiffness.back());
    farthest.setThreshold(tiny);
    if (!farthest.isInvertible()) {
        const MatrixXd force = tiny * chain.stiffness.back().norm() *
                               MatrixXd::Identity(chain.components(), chain.components());
        chain.stiffness.front() += force;
        chain.stiffness.back() += force;
    }
    return chain;
}

/// The layers I-reach .. I+reach-1 to the next ones: u_{I+reach} from the equation of motion.
MatrixXd transfer(const LateralChain& chain, double omega) {
    const auto reach = Index(chain.reach());
    const Index size = chain.components();
    const Index last = (2 * reach - 1) * size;
    const MatrixXd outermost = chain.stiffness.back().inverse();
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
        sum += Complex(0, r) * std::pow(z, r) *
               shape.dot(chain.stiffness[std::size_t(r + reach)] * shape);
    }
    return -sum.real() / (2 * omega);
}

Complex delta(const SideCondition& condition, std::size_t component, double omega, Complex z) {
    return evaluate(condition.residual[component], Complex(0, omega), z);
}

/// Component by component, what the ghost layers 1 .. reach have of a mode, times z^reach.
Eigen::VectorXcd on_ghosts(const PlaneMode& mode, const SideCondition& condition, std::size_t reach,
                           double omega) {
    const Index size = mode.shape.size();
    Eigen::VectorXcd column(size * Index(reach));
    Complex power = 1;
    for (Index layer = Index(reach) - 1; layer >= 0; --layer) {
        for (Index a = 0; a < size; ++a) {
            column(size * layer + a) =
                delta(condition, std::size_t(a), omega, mode.z) * mode.shape(a) * power;
        }
        power *= mode.z;
    }
    return column;
}

double largest_singular_value(const MatrixXcd& matrix) {
    const Eigen::SelfAdjointEigenSolver<MatrixXcd> squared(matrix.adjoint() * matrix,
                                                           Eigen::EigenvaluesOnly);
    return std::sqrt(squared.eigenvalues().maxCoeff());
}

struct Waves {
    Eigen::Vector2d omega;  ///< ascending
    Eigen::Matrix2d shapes;
};

Waves waves_at(const PlaneLattice& lattice, const Eigen::Vector2d& wave_vector) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> modes(
        dynamical_matrix(lattice, wave_vector).value);
    return {modes.eigenvalues().cwiseMax(0).cwiseSqrt(), modes.eigenvectors()};
}

/// Looks for a larger value around a wave vector, in ever smaller steps.
template <class Value>
void climb(Value value, Eigen::Vector2d& at, double& highest, double step) {
    constexpr double smallest = 1e-5;
    while (step > smallest) {
        bool is_higher = false;
        for (const Eigen::Vector2d& way : {Eigen::Vector2d(1, 0), Eigen::Vector2d(-1, 0),
                                           Eigen::Vector2d(0, 1), Eigen::Vector2d(0, -1)}) {
            const Eigen::Vector2d next = at + step * way;
            const double there = value(next);
            if (there > highest) {
                highest = there;
                at = next;
                is_higher = true;
            }
        }
        step = is_higher ? step : step / 2;
    }
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
    const Eigen::EigenSolver<MatrixXd> solver(transfer(without_gaps(chain), omega));
    std::vector<PlaneMode> travelling;
    std::vector<PlaneMode> decaying;
    for (Index i = 0; i < solver.eigenvalues().size(); ++i) {
        const Complex z = solver.eigenvalues()(i);
        const double modulus = std::abs(z);
        // Of a growing solution the last layer, of a decaying one the first has the digits.
        const Eigen::VectorXcd layers = solver.eigenvectors().col(i);
        const Eigen::VectorXcd shape =
            (modulus < 1 ? layers.head(size) : layers.tail(size)).normalized();
        if (modulus < 1 - resolved) {
            decaying.push_back({.z = z, .shape = shape});
        } else if (modulus < 1 + resolved) {
            const Complex unit = z / modulus;
            const double speed = group_velocity(chain, omega, unit, shape);
            if (std::abs(speed) < resolved) {
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

MatrixXcd side_reflection(const std::vector<PlaneMode>& outgoing, const SideCondition& condition,
                          std::size_t reach, double omega) {
    const auto all = Index(outgoing.size());
    const auto travelling = Index(std::ranges::count_if(outgoing, &PlaneMode::travels));
    MatrixXcd conditions(all, all);
    MatrixXcd incident(all, travelling);
    for (Index o = 0; o < all; ++o) {
        conditions.col(o) = on_ghosts(outgoing[std::size_t(o)], condition, reach, omega);
    }
    for (Index i = 0; i < travelling; ++i) {
        const PlaneMode image = mirror_image(outgoing[std::size_t(i)]);
        // z^reach of the columns of outgoing modes undone, which have travelled by it.
        incident.col(i) =
            -on_ghosts(image, condition, reach, omega) * std::pow(image.z, -double(reach));
    }
    MatrixXcd amplitudes = conditions.partialPivLu().solve(incident).topRows(travelling);
    for (Index o = 0; o < travelling; ++o) {
        const PlaneMode& mode = outgoing[std::size_t(o)];
        for (Index i = 0; i < travelling; ++i) {
            const double flux = mode.group_velocity / outgoing[std::size_t(i)].group_velocity;
            amplitudes(o, i) *= std::pow(mode.z, double(reach)) * std::sqrt(flux);
        }
    }
    return amplitudes;
}

std::optional<Amplification> amplification(const LateralChain& chain,
                                           const SideCondition& condition, double omega) {
    const std::vector<PlaneMode> outgoing = outgoing_plane_modes(chain, omega);
    const auto travelling = Index(std::ranges::count_if(outgoing, &PlaneMode::travels));
    if (travelling == 0) {
        return std::nullopt;
    }
    const MatrixXcd fixed = side_reflection(outgoing, fixed_condition(), chain.reach(), omega);
    if (!((fixed.adjoint() * fixed - MatrixXcd::Identity(travelling, travelling)).norm() <
          resolved)) {
        return std::nullopt;
    }
    Amplification result;
    result.alone =
        largest_singular_value(side_reflection(outgoing, condition, chain.reach(), omega));
    result.paired = result.alone;
    if (condition.is_shared()) {
        Eigen::VectorXd g(travelling);
        for (Index i = 0; i < travelling; ++i) {
            const Complex z = outgoing[std::size_t(i)].z;
            g(i) = std::sqrt(
                std::abs(delta(condition, 0, omega, 1.0 / z) / delta(condition, 0, omega, z)));
        }
        result.paired = largest_singular_value(g.asDiagonal() * fixed * g.asDiagonal());
    }
    return result;
}

LargestAmplification largest_amplification(const PlaneLattice& lattice,
                                           const SideCondition& condition, std::size_t samples) {
    LargestAmplification largest;
    const double step = std::numbers::pi / double(samples);
    const auto value_at = [&](const Eigen::Vector2d& at, Index branch) {
        return amplification(lateral_chain(lattice, at.y()), condition,
                             waves_at(lattice, at).omega(branch))
            .value_or(Amplification{});
    };
    Index branch_alone = 0;
    Index branch_paired = 0;
    for (std::size_t i = 0; i < samples; ++i) {
        for (std::size_t j = 0; j <= samples; ++j) {  // peaks lie at 0 and at pi, too
            const Eigen::Vector2d at((double(i) + 0.5) * step, double(j) * step);
            for (const Index branch : {0, 1}) {
                const Amplification value = value_at(at, branch);
                if (value.alone > largest.value.alone) {
                    largest.value.alone = value.alone;
                    largest.alone_at = at;
                    branch_alone = branch;
                }
                if (value.paired > largest.value.paired) {
                    largest.value.paired = value.paired;
                    largest.paired_at = at;
                    branch_paired = branch;
                }
            }
        }
    }
    climb([&](const Eigen::Vector2d& at) { return value_at(at, branch_alone).alone; },
          largest.alone_at, largest.value.alone, step / 2);
    climb([&](const Eigen::Vector2d& at) { return value_at(at, branch_paired).paired; },
          largest.paired_at, largest.value.paired, step / 2);
    return largest;
}

IncidentWave incident_wave(const PlaneLattice& lattice, bool is_P, double xi, double angle) {
    constexpr double aside = 1e-4;
    for (const double turned : {angle, angle - aside, angle + aside}) {
        const Eigen::Vector2d wave_vector(xi * std::cos(turned), xi * std::sin(turned));
        const Waves waves = waves_at(lattice, wave_vector);
        const Eigen::Vector2d overlap = (waves.shapes.transpose() * wave_vector).cwiseAbs();
        IncidentWave wave{.omega = waves.omega((overlap(1) > overlap(0)) == is_P ? 1 : 0),
                          .wave_number = wave_vector.y(),
                          .outgoing = {},
                          .column = 0};
        wave.outgoing = outgoing_plane_modes(lateral_chain(lattice, wave.wave_number), wave.omega);
        if (wave.outgoing.empty()) {
            continue;
        }
        const Complex own = std::polar(1.0, wave_vector.x());
        const auto distance = [&](const PlaneMode& mode) {
            return mode.travels() ? std::min(std::abs(mode.z - own), std::abs(mode.z - 1.0 / own))
                                  : 2;
        };
        wave.column = std::ranges::min_element(wave.outgoing, {}, distance) - wave.outgoing.begin();
        return wave;
    }
    throw std::domain_error("the modes at a side cannot be told from each other");
}

double reflected_in_plane(const IncidentWave& wave, const SideCondition& condition,
                          std::size_t reach) {
    return side_reflection(wave.outgoing, condition, reach, wave.omega)
        .col(wave.column)
        .squaredNorm();
}

}  // namespace nmbcgen
