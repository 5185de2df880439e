// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/plane_dispersion.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/lattice/force_constants.hpp"

namespace nmbcgen {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

struct Bond {
    Vector2d offset;
    Matrix2d phi;
};

std::vector<Bond> bonds_at(const ForceConstants& phi, const Rational& g) {
    std::vector<Bond> bonds;
    for (const auto& [offset, matrix] : phi) {
        Bond bond{.offset = {offset[0], offset[1]}, .phi = {}};
        for (std::size_t a = 0; a < 2; ++a) {
            for (std::size_t b = 0; b < 2; ++b) {
                bond.phi(Eigen::Index(a), Eigen::Index(b)) =
                    nearest_double(evaluate(matrix[a][b], g));
            }
        }
        bonds.push_back(bond);
    }
    return bonds;
}

/// The dynamical matrix of a model that inversion leaves as it is, and its derivatives. A shift has
/// no energy, so sum Phi = 0, and cos t - 1 = -2 sin^2(t/2) keeps the digits of long waves.
struct DynamicalMatrix {
    Matrix2d value = Matrix2d::Zero();
    Matrix2d by_x = Matrix2d::Zero();
    Matrix2d by_y = Matrix2d::Zero();

    DynamicalMatrix(const std::vector<Bond>& bonds, const Vector2d& wave_vector) {
        for (const auto& [offset, phi] : bonds) {
            const double turn = offset.dot(wave_vector);
            value -= 2 * std::pow(std::sin(turn / 2), 2) * phi;
            by_x -= std::sin(turn) * offset.x() * phi;
            by_y -= std::sin(turn) * offset.y() * phi;
        }
    }
};

double degrees(const Vector2d& vector) {
    return std::atan2(vector.y(), vector.x()) * 180 / std::numbers::pi;
}

}  // namespace

std::string plane_dispersion_rows(std::string_view family, const PlaneCurves& curves,
                                  const Rational& g) {
    const auto bonds =
        bonds_at(force_constants(find_vector_family(family).describe(curves.model)), g);
    std::string csv;
    for (const double angle : curves.angles) {
        const double alpha = angle * std::numbers::pi / 180;
        const Vector2d along(std::cos(alpha), std::sin(alpha));
        const double highest = std::numbers::pi / along.cwiseAbs().maxCoeff();
        std::array<std::string, 2> rows;  // of P and S
        Vector2d shape_of_P = along;
        for (unsigned i = 1; i <= curves.samples; ++i) {
            const double xi = highest * i / curves.samples;
            const DynamicalMatrix matrix(bonds, xi * along);
            const Eigen::SelfAdjointEigenSolver<Matrix2d> modes(matrix.value);
            const Vector2d overlap = (modes.eigenvectors().transpose() * shape_of_P).cwiseAbs();
            const Eigen::Index P = overlap(1) >= overlap(0) ? 1 : 0;
            shape_of_P = modes.eigenvectors().col(P);
            for (const Eigen::Index mode : {0, 1}) {
                const Vector2d shape = modes.eigenvectors().col(mode);
                const double omega = std::sqrt(std::max(modes.eigenvalues()(mode), 0.0));
                // d(omega^2) = shape . d(matrix) shape
                const Vector2d group =
                    Vector2d(shape.dot(matrix.by_x * shape), shape.dot(matrix.by_y * shape)) /
                    (2 * omega);
                // The root of what eigenvalues have of roundings.
                constexpr double vanishes = 1e-7;
                rows[mode == P ? 0 : 1] += fmt::format(
                    "{},{},{},{},{},{},{},{}\n", mode == P ? "P" : "S", curves.model.radius_squared,
                    nearest_double(g), angle, xi, omega, omega / xi,
                    omega < vanishes ? std::string("nan,nan")
                                     : fmt::format("{},{}", group.norm(), degrees(group)));
            }
        }
        csv += rows[0] + rows[1];
    }
    return csv;
}

}  // namespace nmbcgen
