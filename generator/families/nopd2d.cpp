// SPDX-License-Identifier: MIT
/// Two-dimensional non-ordinary peridynamics (NOPD), correspondence material, constant influence,
/// stabilised after Silling (Nicely 2018, sections 2, 3 and 6).
#include <fmt/format.h>

#include <cmath>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/families/moduli.hpp"
#include "generator/families/vector_family.hpp"

namespace nmbcgen {
namespace {

constexpr std::size_t x = 0;
constexpr std::size_t y = 1;

/// The square of terms . u, without terms that vanish.
VectorSquare square_of(EnergyPart part, Polynomial weight, std::vector<VectorTerm> terms) {
    std::erase_if(
        terms, [](const VectorTerm& term) { return term.factors[x] == 0 && term.factors[y] == 0; });
    return {part, std::move(weight), std::move(terms)};
}

/// The energy of a node with these neighbours, a family that the reflection of y leaves as it is,
/// of so many in the body.
///
/// The gradient (62) of u: d(u_a)/d(x_b) = sum_J (K^-1 R)_b (u_a,J - u_a,I), K = diag(sum x^2, sum
/// y^2) the shape tensor (61) at V = w = dX = 1. The energy of the strain (64) is (1/2) [k' (e_xx +
/// e_yy)^2 + mu (e_xx - e_yy)^2 + mu (2 e_xy)^2], whose weights are positive at every nu, and that
/// of the null Lagrangian beta (u_x,x u_y,y - u_x,y u_y,x) is beta/4 of the squares of e_xx + e_yy
/// and of the rotation u_x,y - u_y,x, less those of the other two.
std::vector<VectorSquare> node_energy(const std::vector<Offset>& family, std::size_t bonds,
                                      const VectorChoice& choice, const Rational& beta) {
    const Moduli moduli = plane_moduli(choice);
    Rational shape_x = 0;
    Rational shape_y = 0;
    for (const Offset& bond : family) {
        shape_x += bond[x] * bond[x];
        shape_y += bond[y] * bond[y];
    }
    const auto slope = [&](const Offset& bond, std::size_t direction) {
        return Rational(bond[direction]) / (direction == x ? shape_x : shape_y);
    };
    std::vector<VectorSquare> energy;
    const auto add_strain = [&](const Rational& weight, auto factors_at) {
        if (weight == 0) {
            return;
        }
        std::vector<VectorTerm> terms{{Offset{}, {}}};
        for (const Offset& bond : family) {
            terms.push_back({bond, factors_at(slope(bond, x), slope(bond, y))});
            for (const std::size_t direction : {x, y}) {
                terms.front().factors[direction] -= terms.back().factors[direction];
            }
        }
        energy.push_back(square_of(EnergyPart::strain, constant(weight), std::move(terms)));
    };
    using Factors = std::array<Rational, 3>;
    add_strain(moduli.bulk + beta / 2, [](auto dx, auto dy) { return Factors{dx, dy, 0}; });
    add_strain(moduli.shear - beta / 2, [](auto dx, auto dy) { return Factors{dx, -dy, 0}; });
    add_strain(moduli.shear - beta / 2, [](auto dx, auto dy) { return Factors{dy, dx, 0}; });
    add_strain(beta / 2, [](auto dx, auto dy) { return Factors{dy, -dx, 0}; });

    // z = u_J - u_I - (grad u) R on every bond R, |z|^2 with the weight G C_BB/m of (9) to (11),
    // m bonds in the body, C_BB = 12 k'/(pi delta^4).
    const Rational radius_squared = choice.radius_squared;
    const Rational weight = 12 * moduli.bulk / (radius_squared * radius_squared * Rational(bonds));
    for (const Offset& bond : family) {
        for (const std::size_t direction : {x, y}) {
            std::vector<VectorTerm> terms{{Offset{}, {}}};
            terms.front().factors[direction] = -1;
            for (const Offset& other : family) {
                const Rational strain = bond[x] * slope(other, x) + bond[y] * slope(other, y);
                terms.push_back({other, {}});
                terms.back().factors[direction] = int(other == bond) - strain;
                terms.front().factors[direction] += strain;
            }
            energy.push_back(square_of(EnergyPart::stabilisation,
                                       Polynomial(std::vector<Rational>{0, weight}),
                                       std::move(terms)));
        }
    }
    return energy;
}

}  // namespace

VectorModel nopd2d(const VectorChoice& choice) {
    const std::vector<Offset> family = neighbours_in_plane(choice.radius_squared);
    return {.description = fmt::format(
                "2D non-ordinary peridynamics, plane {}, nu = {}, constant influence, family "
                "radius {} (squared, in dX^2), stabilisation g = G/pi",
                choice.plane_strain ? "strain" : "stress", to_string(choice.poisson.value_or(0)),
                choice.radius_squared),
            .source = "Nicely 2018: gradient (62), strain (64), stabilisation (9) to (12)",
            .dimensions = 2,
            .energy = node_energy(family, family.size(), choice, 0)};
}

std::vector<VectorSquare> nopd2d_at_edge(const VectorChoice& choice, unsigned layer,
                                         const Rational& beta) {
    std::vector<Offset> family = neighbours_in_plane(choice.radius_squared);
    const std::size_t bonds = family.size();
    std::erase_if(family, [&](const Offset& bond) { return bond[x] < -int(layer); });
    return node_energy(family, bonds, choice, beta);
}

Rational nopd2d_largest_beta(const VectorChoice& choice) {
    return 2 * plane_moduli(choice).shear;
}

PlaneLimit nopd2d_limit(const VectorChoice& choice, double g, double xi) {
    // Sums over the family become integrals over a disc, of R sin(xi . R) and cos(xi . R): with
    // x = delta xi, |kappa| = 8 J_2(x)/(delta x), and the mean of 2 (1 - cos) less that of the
    // uniform part is 2 - 4 J_1(x)/x - 16 J_2(x)^2/x^2. (J_n/x^n)' = -J_{n+1}/x^n.
    const auto [bulk, shear] = plane_moduli(choice);
    const double delta = std::sqrt(double(choice.radius_squared));
    const double x = delta * xi;
    const auto over_x = [x](double order) { return std::cyl_bessel_j(order, x) / x; };
    const double slope_of_second = over_x(2) / x - over_x(3);  // of J_2/x by x
    const double gradient = 64 / (delta * delta) * over_x(2) * over_x(2);
    const double gradient_slope = 128 / delta * over_x(2) * slope_of_second;
    const double micromodulus = 12 * g * nearest_double(bulk) / std::pow(delta, 4);
    const double rest = micromodulus * (2 - 4 * over_x(1) - 16 * over_x(2) * over_x(2));
    const double rest_slope =
        micromodulus * delta * (4 * over_x(2) - 32 * over_x(2) * slope_of_second);
    const double P = nearest_double(bulk + shear);
    const double S = nearest_double(shear);
    return {.P = P * gradient + rest,
            .P_slope = P * gradient_slope + rest_slope,
            .S = S * gradient + rest,
            .S_slope = S * gradient_slope + rest_slope};
}

}  // namespace nmbcgen
