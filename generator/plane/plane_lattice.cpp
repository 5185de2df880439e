// SPDX-License-Identifier: MIT
#include "generator/plane/plane_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "generator/dense/decompositions.hpp"
#include "generator/dense/portable_math.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/lattice/force_constants.hpp"
#include "generator/lattice/projection.hpp"

namespace nmbcgen {
namespace {

double speed_of(const VectorModel& model, std::size_t direction) {
    const Polynomial squared = speed_squared(model, direction);
    if (squared.is_zero() || squared.degree() > 0) {
        throw NoProjection("long waves of this model have no speed of their own");
    }
    return std::sqrt(nearest_double(squared[0]));
}

}  // namespace

std::vector<PlaneBond> plane_bonds(const VectorModel& model, const Rational& g,
                                   const Rational& damping) {
    std::vector<PlaneBond> bonds;
    for (const auto& [offset, phi] : force_constants(model)) {
        PlaneBond bond{.offset = {offset[0], offset[1]}, .stiffness = {}, .damping = {}};
        for (std::size_t a = 0; a < 2; ++a) {
            for (std::size_t b = 0; b < 2; ++b) {
                const Polynomial& entry = phi[a][b];
                const auto row = Eigen::Index(a);
                const auto column = Eigen::Index(b);
                bond.stiffness(row, column) = nearest_double(evaluate(entry, g));
                bond.damping(row, column) =
                    nearest_double(damping * (evaluate(entry, 1) - evaluate(entry, 0)));
            }
        }
        bonds.push_back(bond);
    }
    return bonds;
}

PlaneLattice plane_lattice(const VectorModel& model, const Rational& g, const Rational& damping) {
    return {.bonds = plane_bonds(model, g, damping),
            .speed_P = speed_of(model, 0),
            .speed_S = speed_of(model, 1)};
}

DynamicalMatrix dynamical_matrix(const std::vector<PlaneBond>& bonds,
                                 const Eigen::Vector2d& wave_vector) {
    DynamicalMatrix matrix;
    for (const auto& [offset, stiffness, damping] : bonds) {
        const double turn = offset[0] * wave_vector.x() + offset[1] * wave_vector.y();
        // A shift has no energy, so sum Phi = 0, and cos t - 1 keeps the digits of long waves.
        matrix.value -= 2 * std::pow(portable::sin(turn / 2), 2) * stiffness;
        matrix.by_x -= portable::sin(turn) * offset[0] * stiffness;
        matrix.by_y -= portable::sin(turn) * offset[1] * stiffness;
    }
    return matrix;
}

double highest_eigenvalue(const PlaneLattice& lattice, std::size_t steps) {
    const double step = std::numbers::pi / double(steps);
    double highest = 0;
    for (std::size_t i = 0; i <= steps; ++i) {
        for (std::size_t j = 0; j <= steps; ++j) {
            const DynamicalMatrix matrix =
                dynamical_matrix(lattice.bonds, {step * double(i), step * double(j)});
            highest = std::max(highest, symmetric_eigenvalues(matrix.value).maxCoeff());
        }
    }
    return highest;
}

LateralChain lateral_chain(const PlaneLattice& lattice, double wave_number) {
    int reach = 0;
    for (const PlaneBond& bond : lattice.bonds) {
        reach = std::max(reach, std::abs(bond.offset[0]));
    }
    const std::vector<Eigen::MatrixXd> none(std::size_t(2 * reach) + 1,
                                            Eigen::MatrixXd::Zero(2, 2));
    LateralChain chain{.stiffness = none, .damping = none};
    for (const PlaneBond& bond : lattice.bonds) {
        // Of u = T (u_x, i u_y), T^-1 Phi exp(i k_t y) T: entries that couple the components are
        // odd in y, the others even.
        const double turn = bond.offset[1] * wave_number;
        Eigen::Matrix2d phase;
        phase << portable::cos(turn), portable::sin(turn), -portable::sin(turn),
            portable::cos(turn);
        const auto layer = std::size_t(bond.offset[0] + reach);
        chain.stiffness[layer] += bond.stiffness.cwiseProduct(phase);
        chain.damping[layer] += bond.damping.cwiseProduct(phase);
    }
    return chain;
}

}  // namespace nmbcgen
