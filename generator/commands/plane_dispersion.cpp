// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/plane_dispersion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "generator/dense/decompositions.hpp"
#include "generator/exact/rational.hpp"
#include "generator/plane/plane_lattice.hpp"

namespace nmbcgen {
namespace {

using Eigen::Vector2d;

double degrees(const Vector2d& vector) {
    return std::atan2(vector.y(), vector.x()) * 180 / std::numbers::pi;
}

}  // namespace

std::string plane_dispersion_rows(std::string_view family, const PlaneCurves& curves,
                                  const Rational& g) {
    const std::vector<PlaneBond> bonds =
        plane_bonds(find_vector_family(family).describe(curves.model), g, 0);
    std::string csv;
    for (const double angle : curves.angles) {
        const double alpha = angle * std::numbers::pi / 180;
        const Vector2d along(std::cos(alpha), std::sin(alpha));
        const double highest = std::numbers::pi / along.cwiseAbs().maxCoeff();
        std::array<std::string, 2> rows;  // of P and S
        Vector2d shape_of_P = along;
        for (unsigned i = 1; i <= curves.samples; ++i) {
            const double xi = highest * i / curves.samples;
            const DynamicalMatrix matrix = dynamical_matrix(bonds, xi * along);
            const SymmetricEigenpairs modes = symmetric_eigenpairs(matrix.value);
            const Vector2d overlap = (modes.vectors.transpose() * shape_of_P).cwiseAbs();
            const Eigen::Index P = overlap(1) >= overlap(0) ? 1 : 0;
            shape_of_P = modes.vectors.col(P);
            for (const Eigen::Index mode : {0, 1}) {
                const Vector2d shape = modes.vectors.col(mode);
                const double omega = std::sqrt(std::max(modes.values(mode), 0.0));
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
