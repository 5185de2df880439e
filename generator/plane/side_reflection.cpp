// SPDX-License-Identifier: MIT
#include "generator/plane/side_reflection.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "generator/dense/decompositions.hpp"
#include "generator/plane/leapfrog.hpp"

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

constexpr double unitary_within = 1e-6;  // R_D, in doubles

/// A column of conditions_on().
Eigen::VectorXcd on_ghosts(const PlaneMode& mode, const SideCondition& condition, std::size_t reach,
                           Complex rate) {
    const Index size = mode.shape.size();
    Eigen::VectorXcd column(size * Index(reach));
    Complex power = 1;
    for (Index layer = Index(reach) - 1; layer >= 0; --layer) {
        for (Index a = 0; a < size; ++a) {
            column(size * layer + a) =
                evaluate(condition.residual[std::size_t(a)], rate, mode.z) * mode.shape(a) * power;
        }
        power *= mode.z;
    }
    return column;
}

/// Ascending.
Eigen::Vector2d frequencies_at(const PlaneLattice& lattice, const Eigen::Vector2d& wave_vector) {
    const Eigen::Matrix2d matrix = dynamical_matrix(lattice.bonds, wave_vector).value;
    const double mean = matrix.trace() / 2;
    const double half = std::hypot((matrix(0, 0) - matrix(1, 1)) / 2, matrix(0, 1));
    return Eigen::Vector2d(mean - half, mean + half).cwiseMax(0).cwiseSqrt();
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

MatrixXcd conditions_on(const std::vector<PlaneMode>& modes, const SideCondition& condition,
                        std::size_t reach, Complex rate) {
    const Index size = modes.empty() ? 0 : modes.front().shape.size();
    MatrixXcd columns(size * Index(reach), Index(modes.size()));
    for (Index o = 0; o < columns.cols(); ++o) {
        columns.col(o) = on_ghosts(modes[std::size_t(o)], condition, reach, rate);
    }
    return columns;
}

MatrixXcd side_reflection(const std::vector<PlaneMode>& outgoing, const SideCondition& condition,
                          std::size_t reach, double omega, double time_step) {
    const Complex rate = rate_at_side(omega, time_step);
    const auto all = Index(outgoing.size());
    const Index travelling = travelling_count(outgoing);
    const MatrixXcd conditions = conditions_on(outgoing, condition, reach, rate);
    MatrixXcd incident(all, travelling);
    for (Index i = 0; i < travelling; ++i) {
        const PlaneMode image = mirror_image(outgoing[std::size_t(i)]);
        // z^reach of the columns of outgoing modes undone, which have travelled by it.
        incident.col(i) =
            -on_ghosts(image, condition, reach, rate) * std::pow(image.z, -double(reach));
    }
    MatrixXcd amplitudes = solution_of(conditions, incident).topRows(travelling);
    for (Index o = 0; o < travelling; ++o) {
        amplitudes.row(o) *= std::pow(outgoing[std::size_t(o)].z, double(reach));
    }
    return in_flux_metric(std::move(amplitudes), outgoing);
}

std::optional<Amplification> amplification(const LateralChain& chain,
                                           const SideCondition& condition, double omega,
                                           double time_step) {
    const std::vector<PlaneMode> outgoing = outgoing_plane_modes(chain, omega);
    const Index travelling = travelling_count(outgoing);
    if (travelling == 0) {
        return std::nullopt;
    }
    const MatrixXcd fixed = side_reflection(outgoing, fixed_condition(), chain.reach(), omega);
    if (!((fixed.adjoint() * fixed - MatrixXcd::Identity(travelling, travelling)).norm() <
          unitary_within)) {
        return std::nullopt;
    }
    Amplification result;
    result.alone = std::sqrt(squared_spectral_norm(
        side_reflection(outgoing, condition, chain.reach(), omega, time_step)));
    result.paired = result.alone;
    if (condition.is_shared()) {
        const Complex rate = rate_at_side(omega, time_step);
        const ShiftPolynomial& residual = condition.residual[0];
        Eigen::VectorXd g(travelling);
        for (Index i = 0; i < travelling; ++i) {
            const Complex z = outgoing[std::size_t(i)].z;
            g(i) = std::sqrt(
                std::abs(evaluate(residual, rate, 1.0 / z) / evaluate(residual, rate, z)));
        }
        result.paired =
            std::sqrt(squared_spectral_norm(MatrixXcd(g.asDiagonal() * fixed * g.asDiagonal())));
    }
    return result;
}

LargestAmplification largest_amplification(const PlaneLattice& lattice,
                                           const SideCondition& condition, std::size_t samples,
                                           double time_step) {
    LargestAmplification largest;
    const double step = std::numbers::pi / double(samples);
    const auto value_at = [&](const Eigen::Vector2d& at, Index branch) {
        return amplification(lateral_chain(lattice, at.y()), condition,
                             frequencies_at(lattice, at)(branch), time_step);
    };
    struct Peak {
        double value = 0;
        Eigen::Vector2d at = Eigen::Vector2d::Zero();
        Index branch = 0;

        void see(double other, const Eigen::Vector2d& there, Index of_branch) {
            if (!(other <= value)) {
                *this = {std::isnan(other) ? HUGE_VAL : other, there, of_branch};
            }
        }
    };
    Peak alone;
    Peak paired;
    for (std::size_t i = 0; i < samples; ++i) {
        for (std::size_t j = 0; j <= samples; ++j) {  // peaks lie at 0 and at pi, too
            const Eigen::Vector2d at((double(i) + 0.5) * step, double(j) * step);
            for (const Index branch : {0, 1}) {
                const auto value = value_at(at, branch);
                ++largest.samples;
                if (value) {
                    ++largest.examined;
                    alone.see(value->alone, at, branch);
                    paired.see(value->paired, at, branch);
                }
            }
        }
    }
    const auto climb_from = [&](Peak& peak, auto part) {
        climb(
            [&](const Eigen::Vector2d& at) {
                const auto value = value_at(at, peak.branch);
                return value ? part(*value) : 0.0;
            },
            peak.at, peak.value, step / 2);
    };
    climb_from(alone, [](const Amplification& value) { return value.alone; });
    climb_from(paired, [](const Amplification& value) { return value.paired; });
    largest.value = {.alone = alone.value, .paired = paired.value};
    return largest;
}

double reflected_in_plane(const ArrivingWave& wave, const SideCondition& condition,
                          std::size_t reach) {
    return side_reflection(wave.outgoing, condition, reach, wave.omega)
        .col(wave.column)
        .squaredNorm();
}

}  // namespace nmbcgen
