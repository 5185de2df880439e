// SPDX-License-Identifier: GPL-2.0-or-later
/// The plane of Nicely 2018, sections 6 and 7: which printed formula holds, (61) to (66), (68),
/// (70) to (74), (80), (81), (84). (67) and (69) define waves and angles; (85):
/// tests/plane/exam_side_reflection.cpp.
/// Units E = rho = dX = 1; angles enter as X = xi_x, Y = xi_y; g = G/pi.
#include <doctest/doctest.h>

#include <array>

#include "generator/exact/rational_function.hpp"
#include "generator/exact/real_roots.hpp"
#include "generator/families/family.hpp"
#include "generator/families/vector_family.hpp"
#include "generator/lattice/band.hpp"
#include "generator/lattice/force_constants.hpp"
#include "generator/lattice/projection.hpp"
#include "generator/lattice/symbol.hpp"
#include "tests/support/laurent.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

const Rational fourth(1, 4);
const Polynomial stabilisation(std::vector<Rational>{0, 1});

Laurent number(const Rational& value) {
    return Laurent(value);
}

/// exp(i (a X + b Y)) + its conjugate, over 2.
Laurent cosine(int a, int b) {
    return Laurent({a, b, 0}, Rational(1, 2)) + Laurent({-a, -b, 0}, Rational(1, 2));
}

/// i sin(a X + b Y)
Laurent i_sine(int a, int b) {
    return Laurent({a, b, 0}, Rational(1, 2)) - Laurent({-a, -b, 0}, Rational(1, 2));
}

const Laurent sine_x_squared = number(-1) * i_sine(1, 0) * i_sine(1, 0);
const Laurent sine_y_squared = number(-1) * i_sine(0, 1) * i_sine(0, 1);
const Laurent sine_x_sine_y = number(-1) * i_sine(1, 0) * i_sine(0, 1);

/// The dynamical matrix of the model at delta^2 = radius_squared.
Laurent entry(unsigned radius_squared, const Rational& nu, std::size_t a, std::size_t b) {
    return {force_constants(nopd2d({.radius_squared = radius_squared, .poisson = nu})), a, b};
}

/// At Y = 0.
Laurent along_x(unsigned radius_squared, std::size_t direction) {
    Laurent sum;
    for (const auto& [offset, matrix] :
         force_constants(nopd2d({.radius_squared = radius_squared, .poisson = fourth}))) {
        sum.add({offset[0], 0, 0}, matrix[direction][direction]);
    }
    return sum;
}

using Cosines = std::vector<std::array<Rational, 2>>;  // p_k + q_k g

/// factor (sum_k (p_k + q_k g) cos k xi) sin^2(xi/2)
Laurent product(const Rational& factor, const Cosines& cosines) {
    Laurent sum;
    for (int k = 0; k < int(cosines.size()); ++k) {
        const auto& [p, q] = cosines[std::size_t(k)];
        sum = sum + Polynomial(std::vector<Rational>{p, q}) * cosine(k, 0);
    }
    return number(factor / 2) * sum * (number(1) - cosine(1, 0));
}

/// What the stabilisation comes to if the neighbour's state is taken on the bond R, not on -R:
///     (g C_BB/m) [sum (1 - 2 cos t + cos 2t) + |s|^2/A] at nu = 1/4, Y = 0.
Laurent wrong_neighbours_state(unsigned radius_squared) {
    const auto family = neighbours_in_plane(radius_squared);
    Laurent sum;
    Laurent i_s;
    int shape = 0;
    for (const Offset& bond : family) {
        sum = sum + number(1) - number(2) * cosine(bond[0], 0) + cosine(2 * bond[0], 0);
        i_s = i_s + number(bond[0]) * i_sine(bond[0], 0);
        shape += bond[0] * bond[0];
    }
    const Rational bulk(2, 3);
    const Rational micromodulus = 12 * bulk / (Rational(radius_squared) * radius_squared);
    return stabilisation * (number(micromodulus / Rational(family.size())) *
                            (sum - number(Rational(1, shape)) * i_s * i_s));
}

}  // namespace

TEST_CASE("(61) to (64): shape tensor, deformation gradient and strain hold") {
    for (const unsigned radius_squared : {1U, 2U, 4U, 5U, 8U, 9U}) {
        const auto family = neighbours_in_plane(radius_squared);
        std::array<int, 3> K{};  // (61): xx, xy, yy
        for (const auto& [i, j, none] : family) {
            K[0] += i * i;
            K[1] += i * j;
            K[2] += j * j;
        }
        CHECK(K[1] == 0);
        // (62): F_ab = delta_ab + sum of (u_a,J - u_a,I) R_b/K_bb. The squares are of e_xx + e_yy,
        // e_xx - e_yy and 2 e_xy.
        const auto energy = nopd2d({.radius_squared = radius_squared, .poisson = fourth}).energy;
        for (const VectorTerm& term : energy[0].terms) {
            const auto& [i, j, none] = term.offset;
            CHECK(term.factors == std::array{Rational(i, K[0]), Rational(j, K[2]), Rational(0)});
        }
        for (const VectorTerm& term : energy[1].terms) {
            const auto& [i, j, none] = term.offset;
            CHECK(term.factors == std::array{Rational(i, K[0]), Rational(-j, K[2]), Rational(0)});
        }
        for (const VectorTerm& term : energy[2].terms) {
            const auto& [i, j, none] = term.offset;
            CHECK(term.factors == std::array{Rational(j, K[2]), Rational(i, K[0]), Rational(0)});
        }
        for (std::size_t square = 0; square < 3; ++square) {
            CHECK(energy[square].terms.size() == family.size());
        }
        // (63), (64): 1/(2 dX) and 1/(4 dX).
        CHECK((radius_squared != 1 || (K[0] == 2 && K[2] == 2)));
    }
}

TEST_CASE("(65): the normal stresses hold") {
    const VectorModel model = nopd2d({.radius_squared = 1, .poisson = fourth});
    // sigma_xx = d(energy)/d(e_xx), of u_{I+1,J} = 1 (e_xx = 1/2) and of v_{I,J+1} = 1 (e_yy =
    // 1/2).
    const Rational sum = evaluate(model.energy[0].weight, 0);
    const Rational difference = evaluate(model.energy[1].weight, 0);
    const Rational printed = 1 / (2 * (1 - fourth) * (1 + fourth));
    CHECK((sum + difference) / 2 == printed);
    CHECK((sum - difference) / 2 == fourth * printed);
}

TEST_CASE("Fig. 12: along x radius 3 has as many zero-energy modes as radius 2, not one more") {
    const auto zeros = [](const std::vector<Polynomial>& symbol) {
        std::vector<Rational> in_x;  // omega^2 at G = 0
        for (const Polynomial& coefficient : band(symbol)) {
            in_x.push_back(evaluate(coefficient, 0));
        }
        return count_real_roots(Polynomial(in_x), -1, 1) - 1;  // xi = 0 apart
    };
    const std::array in_plane{1U, 2U, 2U};
    for (const unsigned n : {1U, 2U, 3U}) {
        const VectorModel model = nopd2d({.radius_squared = n * n, .poisson = fourth});
        CHECK(zeros(symbol_of(project(model, 0).energy)) == in_plane[n - 1]);
        CHECK(zeros(make_model("nopd1d", n).symbol) == n);
    }
}

TEST_CASE("(65): the shear stress is halved") {
    // Of u_{I,J+1} = 1 alone: e_xy = 1/4, so that sigma_xy = 2 mu e_xy = 1/(4 (1 + nu)); printed is
    // 1/(8 (1 + nu)). The energy's square of 2 e_xy has the weight mu, and d(energy)/d(2 e_xy) is
    // the stress.
    const VectorModel model = nopd2d({.radius_squared = 1, .poisson = fourth});
    const VectorSquare& shear = model.energy[2];
    Rational twice_strain = 0;
    for (const VectorTerm& term : shear.terms) {
        twice_strain += term.offset == Offset{0, 1, 0} ? term.factors[0] : Rational(0);
    }
    CHECK(twice_strain == Rational(1, 2));
    const Rational stress = evaluate(shear.weight, 0) * twice_strain;
    CHECK(stress == 1 / (4 * (1 + fourth)));
    CHECK(stress != 1 / (8 * (1 + fourth)));
}

TEST_CASE("(66), (68): the sign is reversed, and the shear modulus doubled") {
    for (const Rational& nu : {Rational(1, 4), Rational(0), Rational(-2, 5)}) {
        const Rational scale = 1 / (1 - nu * nu);
        // Printed, with its denominator nu^2 - 1: omega^2 = -(..).
        const Laurent printed_xx =
            number(-scale) * (sine_x_squared + number(1 - nu) * sine_y_squared);
        const Laurent printed_xy = number(-scale) * sine_x_sine_y;
        CHECK_FALSE(entry(1, nu, 0, 0).at(0) == printed_xx);
        CHECK_FALSE(entry(1, nu, 0, 0).at(0) == number(-1) * printed_xx);
        CHECK_FALSE(entry(1, nu, 0, 1) == number(-1) * printed_xy);
        // What holds.
        CHECK(entry(1, nu, 0, 0).at(0) ==
              number(scale) * (sine_x_squared + number((1 - nu) / 2) * sine_y_squared));
        CHECK(entry(1, nu, 1, 1).at(0) ==
              number(scale) * (sine_y_squared + number((1 - nu) / 2) * sine_x_squared));
        CHECK(entry(1, nu, 0, 1) == number(scale * (1 + nu) / 2) * sine_x_sine_y);
        CHECK(entry(1, nu, 1, 0) == entry(1, nu, 0, 1));
    }
    // The left side of (66) as printed is that of (68): the entry of u_{I+2} is 1/(4 (nu^2 - 1)).
    CHECK(evaluate(
              force_constants(nopd2d({.radius_squared = 1, .poisson = fourth})).at({2, 0, 0})[0][0],
              0) == Rational(-1, 4) / (1 - fourth * fourth));
}

TEST_CASE("(70): an eigenvalue of the matrix with the doubled shear modulus; (71) holds") {
    // Printed: omega^2 = (2/15) [7 (x + y) +- sqrt(x^2 + 62 x y + y^2)], x = sin^2 X, y = sin^2 Y:
    // trace and determinant of c^2/(1 - nu^2) [[x + (1-nu) y, xy], [xy, y + (1-nu) x]].
    const Laurent x = sine_x_squared;
    const Laurent y = sine_y_squared;
    const Laurent trace = number(Rational(28, 15)) * (x + y);
    const Laurent determinant = number(Rational(4, 225)) * (number(49) * (x + y) * (x + y) - x * x -
                                                            number(62) * x * y - y * y);
    const Laurent doubled_xx = number(Rational(16, 15)) * (x + number(Rational(3, 4)) * y);
    const Laurent doubled_yy = number(Rational(16, 15)) * (y + number(Rational(3, 4)) * x);
    CHECK(doubled_xx + doubled_yy == trace);
    CHECK(doubled_xx * doubled_yy - number(Rational(256, 225)) * x * y == determinant);
    // What holds: c_L^2 (x + y) and c_S^2 (x + y), at every angle.
    const Laurent xx = entry(1, fourth, 0, 0).at(0);
    const Laurent yy = entry(1, fourth, 1, 1).at(0);
    const Laurent xy = entry(1, fourth, 0, 1);
    const Laurent P = number(Rational(16, 15)) * (x + y);
    const Laurent S = number(Rational(2, 5)) * (x + y);
    CHECK(xx + yy == P + S);
    CHECK(xx * yy - xy * xy == P * S);
    CHECK_FALSE(xx + yy == trace);
    // (71): omega^2 = (16/15) sin^2 xi and (2/5) sin^2 xi; (70) at Y = 0 has 4/5 for the second.
    CHECK(along_x(1, 0).at(0) == number(Rational(16, 15)) * x);
    CHECK(along_x(1, 1).at(0) == number(Rational(2, 5)) * x);
}

TEST_CASE("(72) and (84) are the P branch") {
    CHECK(along_x(1, 0) == product(Rational(8, 15), {{4, 15}, {4, -15}}));
    const Laurent printed =
        number(Rational(2, 15)) *
        (Polynomial(std::vector<Rational>{8, 90}) * number(1) +
         stabilisation * (number(-60) * (cosine(1, 0) + cosine(0, 1))) +
         Polynomial(std::vector<Rational>{-4, 15}) * (cosine(2, 0) + cosine(0, 2)));
    // Of P: trace minus the S branch, both with the stabilisation S/rho; c_S^2 is 2/5.
    const Laurent trace = entry(1, fourth, 0, 0) + entry(1, fourth, 1, 1);
    const Laurent S_branch = number(Rational(2, 5)) * (sine_x_squared + sine_y_squared);
    const Laurent P_branch = number(Rational(16, 15)) * (sine_x_squared + sine_y_squared);
    const Laurent twice_stabilisation = trace - S_branch - P_branch;
    CHECK(number(2) * printed == number(2) * P_branch + twice_stabilisation);
}

TEST_CASE(
    "(73), (74): the strain's part is that of P and S; the stabilisation's has a bond reversed") {
    const Laurent printed_73 =
        product(Rational(1, 1470),
                {{29 * 64, 29 * 35}, {5 * 576, -5 * 77}, {40 * 32, -40 * 7}, {256, -350}});
    CHECK(along_x(4, 0).at(0) == printed_73.at(0));
    CHECK_FALSE(along_x(4, 0) == printed_73);
    CHECK(printed_73 == printed_73.at(0) + wrong_neighbours_state(4));
    // 153^2 35 = 819315; the printed prefactor 1/(153 sqrt(35) pi) has pi outside of the root.
    const Laurent printed_74 = product(Rational(1, 819315), {{502 * 567, 502 * 340},
                                                             {493290, 41480},
                                                             {192 * 1701, -192 * 425},
                                                             {3 * 52353, -3 * 30260},
                                                             {2 * 22113, -2 * 9860},
                                                             {5103, -20060}});
    CHECK(along_x(9, 1).at(0) == printed_74.at(0));
    CHECK_FALSE(along_x(9, 1) == printed_74);
    CHECK(printed_74 == printed_74.at(0) + wrong_neighbours_state(9));
}

TEST_CASE("(73), (74): both stabilisations agree through xi^4") {
    for (const unsigned radius_squared : {1U, 2U, 4U, 5U, 8U, 9U}) {
        const Laurent right = along_x(radius_squared, 0) - along_x(radius_squared, 0).at(0);
        const Laurent difference = right - wrong_neighbours_state(radius_squared);
        // sum_m d_m m^{2k} = 0 for k = 0, 1, 2.
        for (const int power : {0, 2, 4}) {
            CHECK(difference.moment(power) == Polynomial());
        }
    }
}

TEST_CASE("long waves of every family have the same speeds at every angle and G") {
    // -(1/2) sum_R Phi_ab(R) R_i R_j is the tensor of the elastic plane: mu and lambda' + mu.
    const Rational mu(2, 5);
    const Rational other(2, 3);  // lambda' + mu = 1/(2 (1 - nu))
    const auto delta = [](std::size_t i, std::size_t j) { return Rational(i == j ? 1 : 0); };
    for (const unsigned radius_squared : {1U, 2U, 4U, 5U, 8U, 9U}) {
        const ForceConstants phi =
            force_constants(nopd2d({.radius_squared = radius_squared, .poisson = fourth}));
        for (const std::size_t a : {0U, 1U}) {
            for (const std::size_t b : {0U, 1U}) {
                for (const std::size_t i : {0U, 1U}) {
                    for (const std::size_t j : {0U, 1U}) {
                        Polynomial moment;
                        for (const auto& [offset, matrix] : phi) {
                            moment += matrix[a][b] * constant(Rational(-offset[i] * offset[j], 2));
                        }
                        const Rational elastic =
                            mu * delta(a, b) * delta(i, j) +
                            other * (delta(a, i) * delta(b, j) + delta(a, j) * delta(b, i)) / 2;
                        CHECK(moment == constant(elastic));
                    }
                }
            }
        }
    }
}

TEST_CASE("(80), (81): the coefficients are those of P, for both components") {
    // i omega = i a_1 xi + O(xi^3), c_0 = c_1 = 1: orders 1 and 2 of the residual are
    // 2 i a_1 - i b_1 and (-2 a_1 + b_1)/2, so b_1 = 2 a_1. Squares, c = dX = 1:
    const VectorModel model = nopd2d({.radius_squared = 1, .poisson = fourth});
    const auto b_1_squared = [&](std::size_t direction) {
        return constant(4) * speed_squared(model, direction);
    };
    const Polynomial printed = constant(Rational(64, 15));  // (8/sqrt 15)^2
    CHECK(b_1_squared(0) == printed);
    CHECK(b_1_squared(1) == constant(Rational(8, 5)));
    // The one sqrt 5 of (80) would need 8/sqrt 5.
    CHECK(b_1_squared(0) != constant(Rational(64, 5)));
}
