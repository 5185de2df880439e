// SPDX-License-Identifier: GPL-2.0-or-later
/// 2D NOPD: its equations of motion against a literal evaluation of (2) to (12) of Nicely 2018, its
/// dynamical matrix in closed form, and the chains that P and S waves see.
#include <doctest/doctest.h>

#include <array>
#include <map>
#include <random>

#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"
#include "generator/families/vector_family.hpp"
#include "generator/lattice/force_constants.hpp"
#include "generator/lattice/projection.hpp"
#include "generator/lattice/symbol.hpp"
#include "tests/support/laurent.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

const Rational quarter(1, 4);
const Polynomial symbolic_g(std::vector<Rational>{0, 1});

struct Radius {
    unsigned squared;
    unsigned bonds;  // m
    int shape;       // A = sum of i^2
};
constexpr std::array radii{Radius{1, 4, 2},   Radius{2, 8, 6},   Radius{4, 12, 14},
                           Radius{5, 20, 34}, Radius{8, 24, 50}, Radius{9, 28, 68}};

using Vector = std::array<Rational, 2>;
using Matrix = std::array<std::array<Rational, 2>, 2>;
using Field = std::map<Offset, Vector>;

Offset operator+(const Offset& left, const Offset& right) {
    return {left[0] + right[0], left[1] + right[1], 0};
}
Offset operator-(const Offset& offset) {
    return {-offset[0], -offset[1], 0};
}

Field random_field(int reach, unsigned seed) {
    std::mt19937 random(seed);
    Field field;
    for (int i = -reach; i <= reach; ++i) {
        for (int j = -reach; j <= reach; ++j) {
            field[{i, j, 0}] = {Rational(int(random() % 19)) - 9, Rational(int(random() % 19)) - 9};
        }
    }
    return field;
}

/// Plane stress or strain at E = 1, as in any book.
struct Elasticity {
    Rational lambda;  // of the plane: sigma = lambda tr(eps) + 2 mu eps
    Rational mu;
    Rational bulk;  // k' below (10)
};

Elasticity elasticity(const Rational& nu, bool plane_strain) {
    const Rational mu = 1 / (2 * (1 + nu));
    return plane_strain
               ? Elasticity{nu / ((1 + nu) * (1 - 2 * nu)), mu, 1 / (2 * (1 - nu - 2 * nu * nu))}
               : Elasticity{nu / (1 - nu * nu), mu, 1 / (2 * (1 - nu))};
}

/// (2) to (12) to the letter, at V = w = dX = h_2 = 1: every tensor of a node, none simplified. The
/// stabilisation's factor is g = G/pi, so that C_BB is 12 k'/delta^4.
class Literal {
  public:
    Literal(const VectorChoice& choice, const Rational& stabilisation, Field u)
        : family_(neighbours_in_plane(choice.radius_squared)),
          elastic_(elasticity(choice.poisson.value(), choice.plane_strain)),
          u_(std::move(u)) {
        const Rational square = choice.radius_squared;
        const Rational w_0 = Rational(family_.size());
        state_ = stabilisation * 12 * elastic_.bulk / (square * square) / w_0;
    }

    /// The force density on the node at the origin (2), with (3) and (9).
    Vector force() const {
        Vector sum{};
        for (const Offset& bond : family_) {
            const Vector here = force_state({}, bond);
            const Vector there = force_state(bond, -bond);
            for (std::size_t a = 0; a < 2; ++a) {
                sum[a] += here[a] - there[a];
            }
        }
        return sum;
    }

  private:
    /// F of (6) at a node; K of (4) is inverted as a matrix.
    Matrix deformation_gradient(const Offset& node) const {
        Matrix K{};
        Matrix k{};
        for (const Offset& bond : family_) {
            for (std::size_t a = 0; a < 2; ++a) {
                for (std::size_t b = 0; b < 2; ++b) {
                    const Rational deformed = bond[a] + u_.at(node + bond)[a] - u_.at(node)[a];
                    K[a][b] += bond[a] * bond[b];
                    k[a][b] += deformed * bond[b];
                }
            }
        }
        const Rational determinant = K[0][0] * K[1][1] - K[0][1] * K[1][0];
        const Matrix inverse{{{K[1][1] / determinant, -K[0][1] / determinant},
                              {-K[1][0] / determinant, K[0][0] / determinant}}};
        Matrix F{};
        for (std::size_t a = 0; a < 2; ++a) {
            for (std::size_t b = 0; b < 2; ++b) {
                F[a][b] = k[a][0] * inverse[0][b] + k[a][1] * inverse[1][b];
            }
        }
        return F;
    }

    /// T<R> of (9); K^-1 is 1/A here, as K is diagonal.
    Vector force_state(const Offset& node, const Offset& bond) const {
        const Matrix F = deformation_gradient(node);
        Matrix strain{};
        for (std::size_t a = 0; a < 2; ++a) {
            for (std::size_t b = 0; b < 2; ++b) {
                strain[a][b] = (F[a][b] + F[b][a]) / 2 - int(a == b);
            }
        }
        const Rational trace = strain[0][0] + strain[1][1];
        Rational shape = 0;
        for (const Offset& other : family_) {
            shape += other[0] * other[0];
        }
        Vector T{};
        for (std::size_t a = 0; a < 2; ++a) {
            Rational z = bond[a] + u_.at(node + bond)[a] - u_.at(node)[a];  // (12)
            for (std::size_t b = 0; b < 2; ++b) {
                const Rational stress =
                    2 * elastic_.mu * strain[a][b] + (a == b ? elastic_.lambda * trace : 0);
                T[a] += stress * bond[b] / shape;
                z -= F[a][b] * bond[b];
            }
            T[a] += state_ * z;
        }
        return T;
    }

    std::vector<Offset> family_;
    Elasticity elastic_;
    Rational state_;  // G C_BB/w_0
    Field u_;
};

Rational value(const Polynomial& polynomial, const Rational& at) {
    return evaluate(polynomial, at);
}

/// -sum_R Phi(R) u_R
Vector force(const ForceConstants& phi, const Rational& stabilisation, const Field& u) {
    Vector sum{};
    for (const auto& [offset, matrix] : phi) {
        for (std::size_t a = 0; a < 2; ++a) {
            for (std::size_t b = 0; b < 2; ++b) {
                sum[a] -= value(matrix[a][b], stabilisation) * u.at(offset)[b];
            }
        }
    }
    return sum;
}

/// c0 + c1 (z + 1/z) + .., z = exp(i xi_x), times sin^2(xi/2) = (2 - z - 1/z)/4: the symbol of a
/// printed product. Each coefficient is p + q g.
std::vector<Polynomial> times_sine_squared(const std::vector<std::array<Rational, 2>>& cosines,
                                           const Rational& factor) {
    std::map<int, Polynomial> product;
    for (int m = 0; m < int(cosines.size()); ++m) {
        const auto& [p, q] = cosines[std::size_t(m)];
        const Polynomial entry =
            Polynomial(std::vector<Rational>{p, q}) * constant(factor / (m == 0 ? 1 : 2));
        for (const int sign : {-1, 1}) {
            for (const int shift : {-1, 0, 1}) {
                product[sign * m + shift] +=
                    entry * constant(Rational(shift == 0 ? 2 : -1, m == 0 ? 8 : 4));
            }
        }
    }
    std::vector<Polynomial> symbol;
    for (int m = 0; m <= int(cosines.size()); ++m) {
        symbol.push_back(product[m]);
    }
    return symbol;
}

/// omega^2 of P or S along x, E = rho = 1.
std::vector<Polynomial> symbol_along_x(unsigned radius_squared, std::size_t direction) {
    const VectorModel model = nopd2d({.radius_squared = radius_squared, .poisson = quarter});
    std::vector<Polynomial> symbol = symbol_of(project(model, direction).energy);
    for (Polynomial& coefficient : symbol) {
        coefficient *= speed_squared(model, direction);
    }
    return symbol;
}

}  // namespace

TEST_CASE("families: how many bonds, and the shape tensor's diagonal") {
    for (const Radius& radius : radii) {
        const unsigned squared = radius.squared;
        CAPTURE(squared);
        const auto family = neighbours_in_plane(squared);
        CHECK(family.size() == radius.bonds);
        int sum = 0;
        for (const Offset& bond : family) {
            sum += bond[0] * bond[0];
        }
        CHECK(sum == radius.shape);
    }
}

TEST_CASE("the force is that of (2) to (12), evaluated to the letter") {
    unsigned seed = 0;
    for (const Radius& radius : radii) {
        const unsigned squared = radius.squared;
        for (const bool plane_strain : {false, true}) {
            for (const Rational& nu : {Rational(1, 4), Rational(-1, 3), Rational(0)}) {
                const VectorChoice choice{
                    .radius_squared = squared, .poisson = nu, .plane_strain = plane_strain};
                const Rational stabilisation(int(seed % 5), 3);
                const Field u = random_field(6, ++seed);
                CAPTURE(squared);
                CHECK(force(force_constants(nopd2d(choice)), stabilisation, u) ==
                      Literal(choice, stabilisation, u).force());
            }
        }
    }
}

TEST_CASE("the dynamical matrix in closed form: no square root, at every angle") {
    for (const Radius& radius : radii) {
        const unsigned squared = radius.squared;
        CAPTURE(squared);
        const Rational nu(3, 10);
        const auto [lambda, mu, bulk] = elasticity(nu, false);
        std::array<Laurent, 2> i_kappa;  // i kappa = sum R exp(i xi . R)/A
        Laurent q;                       // sum 1 - cos
        for (const Offset& bond : neighbours_in_plane(squared)) {
            i_kappa[0].add(bond, constant(Rational(bond[0], radius.shape)));
            i_kappa[1].add(bond, constant(Rational(bond[1], radius.shape)));
            q = q + Laurent(Rational(1)) - Laurent(bond, 1);
        }
        const Laurent minus_square = i_kappa[0] * i_kappa[0] + i_kappa[1] * i_kappa[1];
        // S = (g 12 k'/(delta^4 m)) (2 q - A |kappa|^2)
        const Rational factor = 12 * bulk / (Rational(squared) * squared * radius.bonds);
        const Laurent S =
            symbolic_g * (Laurent(2 * factor) * q + Laurent(factor * radius.shape) * minus_square);
        const ForceConstants phi =
            force_constants(nopd2d({.radius_squared = squared, .poisson = nu}));
        for (std::size_t a = 0; a < 2; ++a) {
            for (std::size_t b = 0; b < 2; ++b) {
                const Laurent isotropic = a == b ? S - Laurent(mu) * minus_square : Laurent();
                CHECK(Laurent(phi, a, b) ==
                      isotropic - Laurent(lambda + mu) * i_kappa[a] * i_kappa[b]);
            }
        }
    }
}

TEST_CASE("omega^2 of P and S at normal incidence, nu = 1/4: fixed answers") {
    // delta = 1: (8/15) [(15 g + 4) + (4 - 15 g) cos], (4/5) [(10 g + 1) + (1 - 10 g) cos]
    CHECK(symbol_along_x(1, 0) == times_sine_squared({{4, 15}, {4, -15}}, Rational(8, 15)));
    CHECK(symbol_along_x(1, 1) == times_sine_squared({{1, 10}, {1, -10}}, Rational(4, 5)));
    CHECK(symbol_along_x(4, 0) ==
          times_sine_squared(
              {{1856, 1435}, {5 * 576, -5 * 119}, {20 * 64, -20 * 35}, {4 * 64, -4 * 35}},
              Rational(1, 1470)));
    CHECK(symbol_along_x(4, 1) ==
          times_sine_squared(
              {{696, 1435}, {5 * 216, -5 * 119}, {20 * 24, -20 * 35}, {4 * 24, -4 * 35}},
              Rational(1, 1470)));
    CHECK(symbol_along_x(9, 0) == times_sine_squared({{2 * 94878, 2 * 30685},
                                                      {328860, 6970},
                                                      {8 * 27216, -8 * 4675},
                                                      {277 * 378, -277 * 85},
                                                      {78 * 378, -78 * 85},
                                                      {9 * 378, -9 * 85}},
                                                     Rational(4, 819315)));
    CHECK(symbol_along_x(9, 1) == times_sine_squared({{2 * 142317, 2 * 122740},
                                                      {493290, 27880},
                                                      {32 * 10206, -32 * 4675},
                                                      {277 * 567, -277 * 340},
                                                      {78 * 567, -78 * 340},
                                                      {9 * 567, -9 * 340}},
                                                     Rational(1, 819315)));
}

TEST_CASE("projections: the speed of long waves is 1, and that of the model c_L and c_S") {
    for (const Radius& radius : radii) {
        const unsigned squared = radius.squared;
        CAPTURE(squared);
        const Rational nu(3, 10);
        const VectorModel model = nopd2d({.radius_squared = squared, .poisson = nu});
        CHECK(speed_squared(model, 0) == constant(1 / (1 - nu * nu)));
        CHECK(speed_squared(model, 1) == constant(1 / (2 * (1 + nu))));
        for (const std::size_t direction : {0U, 1U}) {
            const auto symbol = symbol_of(project(model, direction).energy);
            Polynomial square;
            for (std::size_t m = 1; m < symbol.size(); ++m) {
                square -= symbol[m] * constant(Rational(m * m));
            }
            CHECK(square == constant(1));
        }
    }
    // Plane strain: c_L^2 = (1 - nu)/((1 + nu)(1 - 2 nu)).
    const VectorModel strain =
        nopd2d({.radius_squared = 4, .poisson = quarter, .plane_strain = true});
    CHECK(speed_squared(strain, 0) == constant(Rational(6, 5)));
}

TEST_CASE("models that there are not") {
    CHECK_THROWS_WITH_AS(
        nopd2d({.radius_squared = 3}),
        "no node of the square lattice is at a distance of 3 squared: it is no sum "
        "of two squares. The radius below is 2",
        NoSuchModel);
    CHECK_THROWS_WITH_AS(nopd2d({.radius_squared = 1, .poisson = 1}),
                         "Poisson's ratio 1: an isotropic solid needs -1 < nu < 1/2", NoSuchModel);
    CHECK_THROWS_WITH_AS(
        nopd2d({.radius_squared = 1, .poisson = Rational(1, 2), .plane_strain = true}),
        "Poisson's ratio 1/2: an isotropic solid needs -1 < nu < 1/2", NoSuchModel);
    CHECK_THROWS_AS(nopd2d({.radius_squared = 1, .poisson = -1}), NoSuchModel);
    CHECK_THROWS_AS(find_vector_family("nopd1d"), NoSuchModel);
}
