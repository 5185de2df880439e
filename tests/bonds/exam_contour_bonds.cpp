// SPDX-License-Identifier: GPL-2.0-or-later
// Residuals along the contour, by whole dynamical matrices and Simpson's rule.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "generator/bonds/contour_bonds.hpp"
#include "generator/bonds/square_bonds.hpp"
#include "generator/families/bond_lattice.hpp"

using namespace nmbcgen;

namespace {

constexpr double half_turn = std::numbers::pi;
constexpr double contour_length = half_turn * (2 + std::numbers::sqrt2);

BondLattice lattice_of(const SquareBonds& bonds) {
    std::vector<Offset> classes;
    for (const auto& [i, j] : bonds.classes) {
        classes.push_back({i, j, 0});
    }
    return {classes, bonds.weights};
}

std::array<double, 2> at(double along) {
    if (along <= half_turn) {
        return {along, 0};
    }
    if (along <= 2 * half_turn) {
        return {half_turn, along - half_turn};
    }
    const double k = half_turn - (along - 2 * half_turn) / std::numbers::sqrt2;
    return {k, k};
}

/// R of both waves, longitudinal and transverse in the symmetry of the contour.
std::array<double, 2> residuals(const BondLattice& lattice, double along) {
    const auto [k_x, k_y] = at(along);
    const SymmetricMatrix D = lattice.at(k_x, k_y);
    const double square = k_x * k_x + k_y * k_y;
    const double turned = along > 2 * half_turn ? 1 : 0;
    const double P = turned * ((D.xx + D.yy) / 2 + D.xy) + (1 - turned) * D.xx;
    return {P - 1.2 * square, D.xx + D.yy - P - 0.4 * square};
}

/// The integral along the contour, by Simpson's rule on each line.
double integral(double from, double to, const std::function<double(double)>& f) {
    double sum = 0;
    std::vector<double> ends{from};
    for (const double corner : {half_turn, 2 * half_turn}) {
        if (corner > from && corner < to) {
            ends.push_back(corner);
        }
    }
    ends.push_back(to);
    for (std::size_t piece = 0; piece + 1 < ends.size(); ++piece) {
        constexpr int steps = 400;
        const double h = (ends[piece + 1] - ends[piece]) / steps;
        for (int i = 0; i <= steps; ++i) {
            const double share = i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2;
            // Inside of the piece, whose ends belong to two lines.
            const double along =
                std::clamp(ends[piece] + i * h, ends[piece] * (1 + 1e-15), ends[piece + 1]);
            sum += share * f(along) * h / 3;
        }
    }
    return sum;
}

double squared_residual(const SquareBonds& bonds) {
    const BondLattice lattice = lattice_of(bonds);
    return integral(0, contour_length, [&](double along) {
        const auto [P, S] = residuals(lattice, along);
        return P * P + S * S;
    });
}

double sum_of_residuals(const BondLattice& lattice, double along) {
    const auto [P, S] = residuals(lattice, along);
    return P + S;
}

}  // namespace

TEST_CASE("sets on the contour have the solid's speeds") {
    for (const BondMethod method : {BondMethod::point, BondMethod::subdomain, BondMethod::galerkin,
                                    BondMethod::least_squares}) {
        for (unsigned horizon = 2; horizon <= most_square_bonds; ++horizon) {
            if (horizon == 5 && method != BondMethod::least_squares) {
                CHECK_THROWS_AS(contour_bonds(method, horizon), NoSuchBonds);
                continue;
            }
            const BondLattice lattice = lattice_of(contour_bonds(method, horizon));
            for (const double angle : {0.0, 0.3, half_turn / 4}) {
                const auto [fast, slow] = lattice.of_long_waves(angle).eigenvalues();
                // Roundings of weights up to 1000 times the speeds.
                CHECK(std::abs(fast - 1.2) < 1e-12);
                CHECK(std::abs(slow - 0.4) < 1e-12);
            }
        }
    }
}

TEST_CASE("points, parts and projections do what their equations say") {
    for (unsigned horizon = 2; horizon <= 4; ++horizon) {
        CAPTURE(horizon);
        const SquareBonds of_points = contour_bonds(BondMethod::point, horizon);
        const int count = int(of_points.classes.size());
        for (int m = 1; m + 1 < count; ++m) {
            const double along = contour_length * m / (count - 1);
            // Roundings of sums of weights times |b|^2 of up to 1e4.
            CHECK(std::abs(sum_of_residuals(lattice_of(of_points), along)) < 1e-11);
        }
        const SquareBonds of_parts = contour_bonds(BondMethod::subdomain, horizon);
        for (int m = 0; m + 2 < count; ++m) {
            const double part = contour_length / (count - 2);
            // Simpson's rule is good to 1e-9 of the terms here.
            CHECK(std::abs(integral(m * part, (m + 1) * part, [&](double along) {
                      return sum_of_residuals(lattice_of(of_parts), along);
                  })) < 1e-6);
        }
        const SquareBonds projected = contour_bonds(BondMethod::galerkin, horizon);
        for (std::size_t a = 0; a + 2 < projected.classes.size(); ++a) {
            SquareBonds one = projected;
            std::ranges::fill(one.weights, 0.0);
            one.weights[a] = 1;
            const double product = integral(0, contour_length, [&](double along) {
                const auto [k_x, k_y] = at(along);
                const SymmetricMatrix D = lattice_of(one).at(k_x, k_y);
                return (D.xx + D.yy) * sum_of_residuals(lattice_of(projected), along);
            });
            // Simpson's rule, good to 1e-9 of products of up to 1e4.
            CHECK(std::abs(product) < 1e-5);
        }
    }
}

TEST_CASE("the mean square on the contour is least, of sets with these speeds") {
    for (unsigned horizon = 2; horizon <= most_square_bonds; ++horizon) {
        const SquareBonds best = contour_bonds(BondMethod::least_squares, horizon);
        const double least = squared_residual(best);
        for (std::size_t a = 2; a < best.classes.size(); ++a) {
            const auto changed = [&](double change) {
                SquareBonds other = best;
                other.weights[a] += change;
                const auto speeds = [&](std::size_t of) {
                    const auto [P, S] = speeds_of_unit_weight(best.classes[of]);
                    return std::array{double(Real(P)), double(Real(S))};
                };
                // (1, 1) makes up for V_S, (1, 0) for the rest of V_P.
                const double mixed = change * speeds(a)[1] / speeds(1)[1];
                other.weights[1] -= mixed;
                other.weights[0] -= (change * speeds(a)[0] - mixed * speeds(1)[0]) / speeds(0)[0];
                return squared_residual(other);
            };
            constexpr double change = 1e-3;
            const double above = changed(change);
            const double below = changed(-change);
            const double curved = above + below - 2 * least;
            CHECK(curved > 0);
            // A weight off by w would make it 2 w/change: w is below 5e-8.
            CHECK(std::abs(above - below) < 1e-4 * curved);
        }
    }
}

TEST_CASE("closed forms on the contour, and errors (51) over that of alpha = 1") {
    const SquareBonds two = contour_bonds(BondMethod::least_squares, 2);
    REQUIRE(two.alpha[1].closed_form);
    CHECK(to_text(*two.alpha[1].closed_form) == "1/3*sqrt(2)*pi");
    REQUIRE(two.alpha[2].closed_form);
    CHECK(double(value_of(*two.alpha[2].closed_form)) == two.alpha[2].value);
    const auto original = [](unsigned horizon) {
        const std::vector<Rational> ones(square_bond_classes(horizon).size(), Rational(1));
        return figures_of(given_square_bonds(horizon, ones)).residual;
    };
    struct Listed {
        unsigned horizon;
        double floor;  ///< of all sets, by linear programming
        double error;
    };
    for (const auto& [horizon, floor, listed] :
         {Listed{2, .4613, .4757}, Listed{3, .3272, .3930}}) {
        const SquareBonds bonds = contour_bonds(BondMethod::least_squares, horizon);
        const double error = figures_of(bonds).residual / original(horizon);
        CHECK(error > floor);
        CHECK(std::abs(error - listed) < 6e-5);
    }
}

TEST_CASE("signed sums let the waves' errors cancel: points and parts grow at N = 3") {
    for (const auto& [method, grows] :
         {std::pair{BondMethod::point, true}, std::pair{BondMethod::subdomain, true},
          std::pair{BondMethod::galerkin, false}, std::pair{BondMethod::least_squares, false}}) {
        CHECK((lattice_of(contour_bonds(method, 3)).least_squared_speed() < 0) == grows);
        CHECK(lattice_of(contour_bonds(method, 2)).least_squared_speed() > 0);
    }
    CHECK(lattice_of(contour_bonds(BondMethod::galerkin, 4)).least_squared_speed() < 0);
    CHECK_THROWS_AS(contour_bonds(BondMethod::taylor, 3), std::invalid_argument);
    CHECK_THROWS_AS(contour_bonds(BondMethod::bz_ls, 3), std::invalid_argument);
    CHECK_THROWS_AS(contour_bonds(BondMethod::point, 6), std::invalid_argument);
}
