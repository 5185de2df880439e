// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/plane_dispersion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

/// One direction of the wave vector.
struct Ray {
    explicit Ray(double degrees)
        : angle(degrees),
          along(std::cos(degrees * std::numbers::pi / 180),
                std::sin(degrees * std::numbers::pi / 180)),
          highest(std::numbers::pi / along.cwiseAbs().maxCoeff()) {}

    double angle;
    Vector2d along;
    double highest;  ///< wave number in the zone
};

/// slope: the gradient of omega^2 over the wave vector.
std::string row(const std::string& wave, double angle, double xi, double square,
                const Vector2d& slope) {
    constexpr double vanishes = 1e-7;  // the root of what eigenvalues have of roundings
    const double omega = std::sqrt(std::max(square, 0.0));
    const Vector2d group = slope / (2 * omega);
    return fmt::format("{},{},{},{},{},{}\n", wave, angle, xi, omega, omega / xi,
                       omega < vanishes ? std::string("nan,nan")
                                        : fmt::format("{},{}", group.norm(), degrees(group)));
}

/// First of P, then of S.
std::string lattice_rows(const std::vector<PlaneBond>& bonds, const Ray& ray, unsigned samples,
                         const std::array<std::string, 2>& waves) {
    std::array<std::string, 2> rows;
    Vector2d shape_of_P = ray.along;
    for (unsigned i = 1; i <= samples; ++i) {
        const double xi = ray.highest * i / samples;
        const DynamicalMatrix matrix = dynamical_matrix(bonds, xi * ray.along);
        const SymmetricEigenpairs modes = symmetric_eigenpairs(matrix.value);
        const Vector2d overlap = (modes.vectors.transpose() * shape_of_P).cwiseAbs();
        const Eigen::Index P = overlap(1) >= overlap(0) ? 1 : 0;
        shape_of_P = modes.vectors.col(P);
        for (const Eigen::Index mode : {0, 1}) {
            // d(omega^2) = shape . d(matrix) shape
            const Vector2d shape = modes.vectors.col(mode);
            const Vector2d slope(shape.dot(matrix.by_x * shape), shape.dot(matrix.by_y * shape));
            const std::size_t which = mode == P ? 0 : 1;
            rows[which] += row(waves[which], ray.angle, xi, modes.values(mode), slope);
        }
    }
    return rows[0] + rows[1];
}

std::string limit_rows(const VectorFamily& family, const VectorChoice& model, double g,
                       const Ray& ray, unsigned samples, const std::array<std::string, 2>& waves) {
    std::array<std::string, 2> rows;
    for (unsigned i = 1; i <= samples; ++i) {
        const double xi = ray.highest * i / samples;
        const PlaneLimit limit = family.limit(model, g, xi);
        rows[0] += row(waves[0], ray.angle, xi, limit.P, limit.P_slope * ray.along);
        rows[1] += row(waves[1], ray.angle, xi, limit.S, limit.S_slope * ray.along);
    }
    return rows[0] + rows[1];
}

}  // namespace

std::string plane_dispersion_rows(std::string_view family_name, const PlaneCurves& curves,
                                  const Rational& g) {
    const VectorFamily& family = find_vector_family(family_name);
    const std::vector<PlaneBond> bonds = plane_bonds(family.describe(curves.model), g, 0);
    const auto waves = [&](const char* model) {
        const auto wave = [&](const char* polarisation) {
            return fmt::format("{},{},{},{}", model, polarisation, curves.model.radius_squared,
                               nearest_double(g));
        };
        return std::array{wave("P"), wave("S")};
    };
    std::string csv;
    for (const double angle : curves.angles) {
        const Ray ray(angle);
        csv += lattice_rows(bonds, ray, curves.samples, waves("lattice"));
        if (curves.limit) {
            csv += limit_rows(family, curves.model, nearest_double(g), ray, curves.samples,
                              waves("limit"));
        }
    }
    return csv;
}

}  // namespace nmbcgen
