// SPDX-License-Identifier: GPL-2.0-or-later
/// Taylor coefficients of plane lattices in any direction: against the chain of normal incidence,
/// literal expansions of the closed form of omega^2, and Cauchy's solid.
#include <doctest/doctest.h>

#include <array>

#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"
#include "generator/families/vector_family.hpp"
#include "generator/lattice/projection.hpp"
#include "generator/names/projected_family.hpp"
#include "generator/pipeline.hpp"
#include "generator/plane/plane_taylor.hpp"
#include "tests/support/nopd2d.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

const Polynomial g(std::vector<Rational>{0, 1});

/// omega^2/c^2 of waves along (p, q) as a series in the square of the wave number: the sums of
/// facts c^2 |kappa|^2 + S, term by term, with (i p + j q)^n as it stands.
std::vector<Polynomial> literal_squares(unsigned radius_squared, const Rational& speed_squared,
                                        int p, int q, unsigned terms) {
    const auto family = neighbours_in_plane(radius_squared);
    const Rational norm_squared = p * p + q * q;
    Rational shape = 0;
    for (const Offset& bond : family) {
        shape += bond[0] * bond[0];
    }
    // kappa_a = sum_n kappa_a[n] xi^(2n+1) |(p, q)|^-(2n+1), sines; sum 1 - cos likewise.
    std::array<std::vector<Rational>, 2> kappa;
    std::vector<Rational> cosines;
    Rational factorial = 1;  // (2n+1)!
    for (unsigned n = 0; n < terms; ++n) {
        factorial *= n == 0 ? Rational(1) : Rational(2 * n * (2 * n + 1));
        Rational sum_x = 0;
        Rational sum_y = 0;
        Rational sum = 0;
        for (const Offset& bond : family) {
            const Integer along = bond[0] * p + bond[1] * q;
            const Rational odd(pow(along, 2 * n + 1));
            sum_x += bond[0] * odd;
            sum_y += bond[1] * odd;
            sum += Rational(pow(along, 2 * n + 2));
        }
        const Rational sign = n % 2 == 0 ? 1 : -1;
        kappa[0].push_back(sign * sum_x / (factorial * shape));
        kappa[1].push_back(sign * sum_y / (factorial * shape));
        cosines.push_back(sign * sum / (factorial * (2 * n + 2)));
    }
    const Rational bulk(2, 3);
    const Rational micromodulus =
        12 * bulk / (Rational(radius_squared) * radius_squared * Rational(family.size()));
    std::vector<Polynomial> squares;
    Rational scale = norm_squared;
    for (unsigned n = 0; n < terms; ++n) {
        Rational kappa_squared = 0;
        for (unsigned i = 0; i <= n; ++i) {
            for (const auto& part : kappa) {
                kappa_squared += part[i] * part[n - i];
            }
        }
        const Rational rest = micromodulus * (2 * cosines[n] - shape * kappa_squared);
        squares.push_back(constant(kappa_squared / scale) +
                          g * constant(rest / (scale * speed_squared)));
        scale *= norm_squared;
    }
    return squares;
}

/// (sum a_{2k+1} x^(2k+1))^2 + omega^2/c^2 = 0, x = i xi.
void check_solves(const std::vector<Polynomial>& a, const std::vector<Polynomial>& squares) {
    for (std::size_t n = 0; n < a.size(); ++n) {
        Polynomial sum;
        for (std::size_t i = 0; i <= n; ++i) {
            sum += a[i] * a[n - i];
        }
        // x^(2n+2) = (-1)^(n+1) xi^(2n+2)
        CHECK(sum == squares[n] * constant(n % 2 == 0 ? 1 : -1));
    }
}

Polynomial at(const std::vector<Polynomial>& in_q, const Rational& q) {
    Polynomial value;
    for (std::size_t j = in_q.size(); j-- > 0;) {
        value = value * constant(q) + in_q[j];
    }
    return value;
}

}  // namespace

TEST_CASE("at normal incidence they are those of the chain") {
    constexpr unsigned order = 3;
    for (const unsigned radius_squared : {1U, 2U, 4U, 5U, 8U, 9U}) {
        for (const Polarisation polarisation : {Polarisation::P, Polarisation::S}) {
            const ProjectedFamily chain{.family = "nopd2d",
                                        .model = of_paper(radius_squared),
                                        .polarisation = polarisation};
            const Table table = derive({.family = name_of(chain),
                                        .horizon = radius_squared == 9U ? 3U
                                                   : radius_squared < 4 ? 1U
                                                                        : 2U,
                                        .order = order,
                                        .stride = 1,
                                        .stabilisation = {}});
            const PlaneTaylor taylor =
                plane_taylor(nopd2d(of_paper(radius_squared)),
                             polarisation == Polarisation::P ? 0 : 1, 1, order);
            for (std::size_t k = 0; k <= order; ++k) {
                CHECK(taylor.a[k] == table.taylor[2 * k]);
            }
        }
    }
}

TEST_CASE("at any direction they solve the literal expansion of the closed form") {
    constexpr unsigned order = 4;
    for (const unsigned radius_squared : {1U, 2U, 4U, 5U, 8U, 9U}) {
        const VectorModel model = nopd2d(of_paper(radius_squared));
        for (const auto& [polarisation, speed_squared] :
             {std::pair(0U, Rational(16, 15)), std::pair(1U, Rational(2, 5))}) {
            const PlaneTaylorClosed closed = plane_taylor_closed(model, polarisation, order);
            CHECK(closed.speed_squared == speed_squared);
            for (const auto& [p, q] :
                 {std::pair(1, 0), std::pair(3, 4), std::pair(5, -12), std::pair(7, 2)}) {
                const auto squares =
                    literal_squares(radius_squared, speed_squared, p, q, order + 1);
                const Rational cosine_squared(p * p, p * p + q * q);
                const PlaneTaylor taylor = plane_taylor(model, polarisation, cosine_squared, order);
                CHECK(taylor.speed_squared == speed_squared);
                check_solves(taylor.a, squares);
                const Rational in_q = 4 * cosine_squared * (1 - cosine_squared);
                for (std::size_t k = 0; k <= order; ++k) {
                    CHECK(at(closed.a[k], in_q) == taylor.a[k]);
                }
            }
        }
    }
}

TEST_CASE("delta = 1: fixed answers") {
    const PlaneTaylorClosed P = plane_taylor_closed(nopd2d(of_paper(1)), 0, 1);
    // omega^2/c^2 = sin^2 x + sin^2 y at G = 0: 1/6 (cos^4 + sin^4) = 1/6 - q/12.
    CHECK(P.a[1][0] == constant(Rational(1, 6)) - g * constant(Rational(15, 32)));
    CHECK(P.a[1][1] == g * constant(Rational(15, 64)) - constant(Rational(1, 12)));
}

TEST_CASE("bonds: Cauchy's solid, and lattices whose long waves are no rational ones") {
    // w_1 of (1, 0), w_2 of (1, 1): isotropic at w_1 = 4 w_2 (c_P^2 = 3 c_S^2).
    const VectorModel isotropic = bond2d({.radius_squared = 2, .weights = {4, 1}});
    CHECK(plane_taylor_closed(isotropic, 0, 2).speed_squared == 6);
    CHECK(plane_taylor_closed(isotropic, 1, 2).speed_squared == 2);
    const VectorModel other = bond2d({.radius_squared = 2, .weights = {1, 1}});
    CHECK(plane_taylor(other, 0, Rational(1, 2), 2).speed_squared == Rational(9, 2));
    CHECK_THROWS_WITH_AS(
        plane_taylor(other, 0, Rational(9, 25), 1),
        "the speed of long waves in this direction is no root of a rational number", NoProjection);
    CHECK_THROWS_AS(plane_taylor_closed(other, 0, 1), NoProjection);
    const VectorModel axes = bond2d({.radius_squared = 1, .weights = {1}});
    CHECK(plane_taylor(axes, 0, 1, 1).a[1] == constant(Rational(1, 24)));
    CHECK_THROWS_AS(plane_taylor(axes, 1, 1, 1), NoProjection);
    CHECK_THROWS_AS(plane_taylor(axes, 0, Rational(1, 2), 1), NoProjection);
}
